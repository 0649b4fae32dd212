#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "grammar/codes.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("explain tells what a code means, with an example mended",
          "[explain]") {
  const auto ran = RunPlsc({"explain", "P2003"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(
      ran.out ==
      "P2003: an argument that must be a whole number\n\n"
      "The parameter counts something, and so its argument is a whole number,\n"
      "written without point and exponent, at most 2^53.\n\n"
      "Wrong:\n\n"
      "    plsc 1\n"
      "    alphabet plasticoding 1\n"
      "    rule B -> { move_ref_I(1.5, 2) }\n\n"
      "Mended:\n\n"
      "    plsc 1\n"
      "    alphabet plasticoding 1\n"
      "    rule B -> { move_ref_I(1, 2) }\n");
}

TEST_CASE("explain takes codes as they are printed or typed", "[explain]") {
  const std::string text = RunPlsc({"explain", "P2001"}).out;
  CHECK(RunPlsc({"explain", "p2001"}).out == text);
  CHECK(RunPlsc({"explain", "error[P2001]"}).out == text);
}

TEST_CASE("explain of an unknown code is a usage error", "[explain]") {
  const auto ran = RunPlsc({"explain", "P20001"});
  CHECK(ran.exit == 2);
  CHECK(ran.out.empty());
  CHECK(ran.err.find("there is no code 'P20001'; did you mean 'P2001'?") !=
        std::string::npos);
  CHECK(RunPlsc({"explain"}).exit == 2);
}

TEST_CASE("explain --list has a line for every code", "[explain]") {
  const auto text = RunPlsc({"explain", "--list"});
  const auto json = RunPlsc({"explain", "--list", "--format", "json"});
  CHECK(text.exit == 0);
  CHECK(json.exit == 0);
  std::istringstream text_lines(text.out);
  std::istringstream json_lines(json.out);
  for (const CodeInfo& info : DiagnosticCodes()) {
    std::string line;
    REQUIRE(std::getline(text_lines, line));
    CHECK(line == std::string(info.number) + "  " + std::string(info.meaning));
    REQUIRE(std::getline(json_lines, line));
    const auto object = nlohmann::json::parse(line);
    CHECK(object["code"] == info.number);
    CHECK(object["meaning"] == info.meaning);
    for (const char* key : {"explanation", "wrong", "mended"})
      CHECK_FALSE(object[key].get<std::string>().empty());
  }
  CHECK(text_lines.peek() == EOF);
  CHECK(json_lines.peek() == EOF);
}

}  // namespace
}  // namespace plsc
