#include "runtime/cli/commands/view_editable.h"

#include <catch2/catch.hpp>

#include "runtime/pages/page.h"
#include "runtime/pages/web_module.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

TEST_CASE("an editable page holds the text and the module, or is refused",
          "[view_editable]") {
  const test::TemporaryFolder folder;
  const std::string robot = folder.Write("a.pls", test::kPlasticText);
  const std::string page = folder / "a.html";
  const test::Ran ran =
      test::RunPlsc({"view", "--editable", robot, "-o", page});
  if (!HasPages() || !FindWebModule()) {
    CHECK(ran.exit == 1);
    CHECK(ran.err.find(HasPages() ? "docs/web.md" : "npm") !=
          std::string::npos);
    CHECK_FALSE(std::filesystem::exists(page));
    return;
  }
  REQUIRE(ran.exit == 0);
  const std::string html = test::ReadFile(page);
  CHECK(html.find("genotype plastic") != std::string::npos);
  CHECK(html.find(FindWebModule()->packed) != std::string::npos);
  CHECK(html.size() < 1600000);  // what may be sent by mail
}

TEST_CASE("an editable page is of one genotype file", "[view_editable]") {
  const test::TemporaryFolder folder;
  const std::string robot = folder.Write("a.pls", test::kPlasticText);
  CHECK(test::RunPlsc(
            {"view", "--editable", robot, robot, "-o", folder / "a.html"})
            .exit == 1);
  CHECK(test::RunPlsc(
            {"view", "--editable", "--explain", robot, "-o", folder / "a.html"})
            .exit == 2);
  CHECK(folder.Files() == std::vector<std::string>{"a.pls"});
}

}  // namespace
}  // namespace plsc
