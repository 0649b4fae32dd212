#include "runtime/pages/page.h"

#include <catch2/catch.hpp>

#include "runtime/pages/bundles.h"

namespace plsc {

namespace {

std::size_t Count(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + part.size()))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("A page holds its title and its data, whatever is in them",
          "[page]") {
  const std::string page =
      PageHtml(PageKind::kView, "a <b> & \"c\"",
               R"({"name":"</script><script>alert(1)</script><!--"})");
  CHECK(page.find("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>") !=
        std::string::npos);
  CHECK(page.find(R"({"name":"\u003c/script>\u003cscript>alert(1))") !=
        std::string::npos);
  // The data's, the program's, and none of the name's.
  CHECK(Count(page, "</script>") == 2);
  CHECK(Count(page, "<!--") == 0);
  CHECK(Count(page, "</style>") == 1);
}

TEST_CASE("A page may load nothing", "[page]") {
  const std::string page = PageHtml(PageKind::kReport, "", "{}");
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(Count(page, " src=") == 0);
  CHECK(Count(page, "@import") == 0);
}

TEST_CASE("A live page may run a module and ask its server, others may not",
          "[page]") {
  for (const char* right :
       {"'wasm-unsafe-eval'", "worker-src blob:", "connect-src 'self'"}) {
    CHECK(Count(PageHtml(PageKind::kLive, "", "{}"), right) == 1);
    CHECK(Count(PageHtml(PageKind::kView, "", "{}"), right) == 0);
  }
}

TEST_CASE("Every page has its program, if this was built with npm", "[page]") {
  for (const PageKind kind : {PageKind::kReport, PageKind::kView,
                              PageKind::kExplain, PageKind::kLive}) {
    const Bundle bundle = BundleOf(kind);
    CHECK(bundle.script.empty() != HasPages());
    CHECK(bundle.style.empty() != HasPages());
    // As bytes, so that a '?' or a quote that C++ took otherwise is seen.
    CHECK(bundle.script.find('\0') == std::string_view::npos);
  }
}

}  // namespace plsc
