#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

constexpr const char* kGap =
    "plsc 1\nalphabet plasticoding 1\nsense hot: bool\niterations 1\n"
    "rule C -> if hot = True then { C add_left B }\n";

TEST_CASE("lint shows warnings, and denies them on demand", "[cli][lint]") {
  const auto ran = RunPlsc({"lint", "-"}, kGap);
  CHECK(ran.exit == 0);
  CHECK(ran.out == "<stdin>: 1 warning\n");
  CHECK(ran.err.find("warning[W3003]: no rule for 'C' is active when hot = "
                     "False") != std::string::npos);
  CHECK(RunPlsc({"lint", "--deny", "-"}, kGap).exit == 1);
  const auto fine = RunPlsc({"lint", "--deny", "-"}, test::kPlasticText);
  CHECK(fine.exit == 0);
  CHECK(fine.out == "<stdin>: 0 warnings\n");
}

TEST_CASE("lint stops at errors", "[cli][lint]") {
  CHECK(RunPlsc({"lint", "-"}, "plsc 1\nrule").exit == 1);
  CHECK(RunPlsc({"lint", "/nowhere.pls"}).exit == 1);
  CHECK(RunPlsc({"lint"}).exit == 2);
}

TEST_CASE("lint prints JSON lines", "[cli][lint]") {
  const auto ran = RunPlsc({"lint", "--format", "json", "-"}, kGap);
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  const auto json = nlohmann::json::parse(ran.out);
  CHECK(json["code"] == "W3003");
  CHECK(json["line"] == 5);
}

TEST_CASE("check shows lints on demand and stays fine", "[cli][lint]") {
  CHECK(RunPlsc({"check", "-"}, kGap).err.empty());
  const auto ran = RunPlsc({"check", "--lint", "-"}, kGap);
  CHECK(ran.exit == 0);
  CHECK(ran.err.find("W3003") != std::string::npos);
}

TEST_CASE("develop names the line that makes it grow too long", "[cli][lint]") {
  const auto ran = RunPlsc({"develop", "-"},
                           "plsc 1\nalphabet plasticoding 1\niterations 90\n"
                           "rule C -> { C B }\nrule B -> { B B }\n");
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("error[P4001]") != std::string::npos);
  CHECK(ran.err.find("<stdin>:3:12") != std::string::npos);
}

}  // namespace
}  // namespace plsc
