#include "runtime/lsp/analysis.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("The name under, before and behind the cursor is found", "[lsp]") {
  Analysis analysis(kTestUri, "plsc 1\nsense hot: bool\nlet x = 1\n");
  CHECK(analysis.MentionAt(13)->name == "hot");
  CHECK(analysis.MentionAt(14)->name == "hot");
  CHECK(analysis.MentionAt(16)->name == "hot");
  CHECK(analysis.MentionAt(12) == nullptr);
  CHECK(analysis.MentionAt(17) == nullptr);
  CHECK(analysis.MentionAt(0) == nullptr);
  CHECK(analysis.MentionAt(1000000) == nullptr);
}

TEST_CASE("A place belongs to the genotype before it", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\ngenotype one\n"
                    "rule C -> { C }\ngenotype two\nrule B -> { B }\n");
  const auto name = [&](std::string_view at) {
    return analysis
        .SectionAt(static_cast<std::uint32_t>(analysis.text().find(at)))
        .scope.header.name;
  };
  CHECK(name("plsc") == "one");
  CHECK(name("rule C") == "one");
  CHECK(name("genotype two") == "two");
  CHECK(name("rule B") == "two");
}

TEST_CASE("Broken texts can be asked anything", "[lsp]") {
  for (const char* text :
       {"", "plsc", "\xFF\xFE", "plsc 1\nrule B -> if a ="}) {
    Analysis analysis(kTestUri, text);
    CHECK_FALSE(analysis.compiled());
    CHECK(analysis.sections().size() == 1);
    CHECK(analysis.MentionAt(0) == nullptr);
  }
}

}  // namespace plsc::lsp
