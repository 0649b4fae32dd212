#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("check says what a correct file holds", "[check]") {
  const auto ran = RunPlsc({"check", "-"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(ran.out ==
        "<stdin>: genotype plastic, alphabet plasticoding, 2 rules, 1 states, "
        "2 environments\n");
  CHECK(ran.err.empty());
}

TEST_CASE("check shows the place of an error", "[check]") {
  const auto ran = RunPlsc({"check", "-"},
                           "plsc 1\ngenotype a\nalphabet plasticoding 1\n"
                           "rule C -> { C add_lef B }\n");
  CHECK(ran.exit == 1);
  CHECK(ran.out.empty());
  CHECK(ran.err.find("<stdin>:4:15") != std::string::npos);
  CHECK(ran.err.find("4 | rule C -> { C add_lef B }\n"
                     "  |               ^^^^^^^") != std::string::npos);
}

TEST_CASE("check prints diagnostics as JSON lines", "[check]") {
  const auto ran = RunPlsc({"check", "-", "--format", "json"},
                           "plsc 1\ngenotype a\nalphabet plasticoding 1\n"
                           "rule C -> { C add_lef B }\nrule Q -> { B }\n");
  CHECK(ran.exit == 1);
  std::istringstream lines(ran.out);
  std::vector<int> error_lines;
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    CHECK(json["severity"] == "error");
    CHECK(json["file"] == "<stdin>");
    CHECK(json["byte_end"] > json["byte_begin"]);
    error_lines.push_back(json["line"]);
  }
  CHECK(error_lines == std::vector<int>{4, 5});
}

TEST_CASE("check looks at every file", "[check]") {
  const test::TemporaryFolder folder;
  const std::string good = folder.Write("good.pls", test::kPlasticText);
  const auto ran = RunPlsc({"check", folder / "none.pls", good});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("No such file") != std::string::npos);
  CHECK(ran.out.find("good.pls: genotype plastic") != std::string::npos);
}

TEST_CASE("check --allow-range warns of arguments outside their range",
          "[check]") {
  const std::string text =
      "plsc 1\ngenotype a\nalphabet plasticoding 1\n"
      "rule C -> { C add_left T(1.5) }\n";
  CHECK(RunPlsc({"check", "-"}, text).exit == 1);
  const auto ran = RunPlsc({"check", "-", "--allow-range"}, text);
  CHECK(ran.exit == 0);
  CHECK(ran.err.find("warning[P2004]") != std::string::npos);
}

TEST_CASE("check of hostile bytes prints an error and valid JSON", "[check]") {
  const std::string hostile = "plsc 1\n\xFF\xFE\x1B[31m\0rule";
  CHECK(RunPlsc({"check", "-"}, hostile).exit == 1);
  const auto ran = RunPlsc({"check", "-", "--format", "json"}, hostile);
  CHECK(ran.exit == 1);
  CHECK(nlohmann::json::accept(ran.out.substr(0, ran.out.find('\n'))));
}

}  // namespace
}  // namespace plsc
