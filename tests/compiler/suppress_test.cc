#include "compiler/suppress.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "compiler/compiled.h"
#include "compiler/format.h"

namespace plsc {
namespace {

using testing::CodesOf;

constexpr const char* kConstant =
    "rule B -> if hot = True or hot = False then { B }";

TEST_CASE("Comments silence the warnings of the item that they belong to",
          "[suppress]") {
  const std::string head = "plsc 1\nalphabet plasticoding 1\nsense hot: bool\n";
  const std::string rule = kConstant;
  struct Row {
    const char* why;
    std::string text;
    const char* codes;
  };
  const std::vector<Row> rows = {
      {"no comment", head + rule, "W3002"},
      {"on the line before", head + "# plsc: allow W3002\n" + rule, ""},
      {"behind the item", head + rule + " # plsc: allow W3002", ""},
      {"in the item",
       head + "rule B -> if hot = True or hot = False then { # plsc: allow "
              "W3002\n B }",
       ""},
      {"with other comments between",
       head + "# plsc: allow W3002\n# why\n\n" + rule, ""},
      {"several codes", head + "# plsc: allow W3003, W3002\n" + rule, ""},
      {"no blank is needed", head + "#plsc:allow W3002\n" + rule, ""},
      {"a line end of DOS", head + "# plsc: allow W3002\r\n" + rule, ""},
      {"for the whole file", head + rule + "\n# plsc: allow-file W3002\n", ""},
      {"above the version line", "# plsc: allow-file W3002\n" + head + rule,
       ""},
      {"another code", head + "# plsc: allow W3003\n" + rule, "W3002"},
      {"another item",
       head + "# plsc: allow W3002\nrule T -> { T(1) }\n" + rule, "W3002"},
      {"behind the item before",
       head + "iterations 2 # plsc: allow W3002\n" + rule, "W3002"},
      {"a remark of people", head + "# allow W3002\n" + rule, "W3002"},
      {"one of two rules", head + "# plsc: allow W3002\n" + rule + "\n" + rule,
       "W3002"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(CodesOf(row.text) == row.codes);
    }
  }
}

TEST_CASE("Comments that ask for what does not exist are warned of",
          "[suppress]") {
  struct Row {
    const char* comment;
    const char* message;
    const char* help;
  };
  const std::vector<Row> rows = {
      {"# plsc: allow W3020", "there is no warning 'W3020'",
       "did you mean 'W3002'?"},
      {"# plsc: allow everything", "there is no warning 'everything'",
       "'plsc explain' lists the codes"},
      {"# plsc: allow P2001", "P2001 is an error, which cannot be allowed", ""},
      {"# plsc: allow", "expected a code after 'allow'",
       "such as '# plsc: allow W3002'"},
      {"# plsc: deny W3002", "expected 'allow' or 'allow-file', found 'deny'",
       "a comment that starts with '# plsc:' is for plsc"},
      {"# plsc:", "expected 'allow' or 'allow-file' after '# plsc:'", ""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.comment) {
      const Source source("a", std::string("plsc 1\n") + row.comment +
                                   "\nalphabet plasticoding 1\n");
      const Result<Program> program = Compile(source);
      REQUIRE(program);
      REQUIRE(program.diagnostics().size() == 1);
      const Diagnostic& warning = program.diagnostics()[0];
      CHECK(warning.code == Code::kWrongAllow);
      CHECK(warning.severity == Severity::kWarning);
      CHECK(warning.message == row.message);
      CHECK(warning.help == row.help);
    }
  }
}

TEST_CASE("An allow that belongs to no item is warned of", "[suppress]") {
  CHECK(CodesOf("# plsc: allow W3002\nplsc 1\nalphabet plasticoding 1") ==
        "W1001");
  CHECK(CodesOf("plsc 1\nalphabet plasticoding 1\n# plsc: allow W3002") ==
        "W1001");
}

TEST_CASE("Errors stay errors", "[suppress]") {
  CHECK(CodesOf("plsc 1\nalphabet plasticoding 1\n"
                "# plsc: allow-file W3002\nrule Q -> { B }") == "P2001");
}

TEST_CASE("Formatting a file keeps what its comments silence", "[suppress]") {
  const Source source("a", std::string("plsc 1\n# plsc: allow W3002\n") +
                               kConstant + "\n" + kConstant +
                               " # plsc: allow W3002\n" +
                               "sense hot: bool alphabet plasticoding 1\n");
  const Result<std::string> formatted = Format(source);
  REQUIRE(formatted);
  CHECK(CodesOf(std::string(source.text())).empty());
  CHECK(CodesOf(*formatted).empty());
}

}  // namespace
}  // namespace plsc
