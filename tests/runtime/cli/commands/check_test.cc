#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "runtime/cli/run.h"
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

// `count` errors, one a line.
std::string Errors(int count) {
  std::string text = "plsc 1\nalphabet plasticoding 1\n";
  for (int i = 0; i < count; ++i) text += "rule Q -> { B }\n";
  return text;
}

std::size_t CountIn(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + what.size()))
    ++count;
  return count;
}

TEST_CASE("check --max-errors limits what text shows", "[check]") {
  const auto usual = RunPlsc({"check", "-"}, Errors(25));
  CHECK(CountIn(usual.err, "error[P2001]") == 20);
  CHECK(usual.err.find("... and 5 more (--max-errors 0 shows all)\n") !=
        std::string::npos);
  const auto two = RunPlsc({"check", "-", "--max-errors", "2"}, Errors(25));
  CHECK(CountIn(two.err, "error[P2001]") == 2);
  CHECK(two.err.find("... and 23 more") != std::string::npos);
  const auto all = RunPlsc({"check", "-", "--max-errors", "0"}, Errors(25));
  CHECK(CountIn(all.err, "error[P2001]") == 25);
  CHECK(all.err.find("more") == std::string::npos);
  CHECK(RunPlsc({"check", "-", "--max-errors", "-1"}, Errors(1)).exit == 2);
}

TEST_CASE("check is painted only when asked or on a terminal", "[check]") {
  const std::string text = Errors(1);
  const auto plain = RunPlsc({"check", "-"}, text);
  CHECK(plain.err.find('\033') == std::string::npos);
  CHECK(RunPlsc({"check", "-", "--color", "never"}, text).err == plain.err);
  const auto painted = RunPlsc({"check", "-", "--color", "always"}, text);
  CHECK(painted.err.find("\033[1;31merror[P2001]\033[0m") == 0);
  CHECK(painted.out == plain.out);

  const auto on_terminal = [&](const std::vector<std::string>& arguments) {
    std::istringstream in(text);
    std::ostringstream out;
    std::ostringstream err;
    cli::Io io{in, out, err, true, true};
    cli::Main(arguments, io);
    return err.str();
  };
  CHECK(on_terminal({"check", "-"}) == painted.err);
  CHECK(on_terminal({"check", "-", "--color", "never"}) == plain.err);
}

TEST_CASE("check --format github prints annotations", "[check]") {
  const auto ran = RunPlsc({"check", "-", "--format", "github"}, Errors(2));
  CHECK(ran.exit == 1);
  CHECK(ran.err.empty());
  CHECK(ran.out.find("::error file=<stdin>,line=3,col=6,endLine=3,endColumn=7,"
                     "title=P2001::unknown symbol 'Q'") == 0);
  CHECK(CountIn(ran.out, "\n") == 2);
}

}  // namespace
}  // namespace plsc
