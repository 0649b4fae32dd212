#include "runtime/lsp/signature_help.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

Json HelpAt(const std::string& with_mark) {
  const Marked marked("plsc 1\nalphabet plasticoding 1\n" + with_mark);
  Analysis analysis(kTestUri, marked.text);
  return SignatureHelp(analysis, marked.offset);
}

}  // namespace

TEST_CASE("Parameters are told while arguments are written", "[lsp]") {
  struct Row {
    const char* text;
    int active;  ///< parameter; -1: no help
  };
  const Row rows[] = {
      {"rule C -> { C A1(@", 0},
      {"rule C -> { C A1(0.5@, 2, 3, 1) }", 0},
      {"rule C -> { C A1(0.5,@", 1},
      {"rule C -> { C A1(0.5, 2, 3, @1) }", 3},
      {"rule C -> { C A1(0.5, 2,\n# why\n3, @", 3},
      {"test t -> { C A1(@", 0},
      {"rule C -> { C A1@(0.5, 2, 3, 1) }", -1},
      {"rule C -> { C A1(0.5, 2, 3, 1)@ }", -1},
      {"rule C -> { C A1(0.5, # why@\n", -1},
      {"rule C -> { C nix(@", -1},
      {"rule C -> { C A1(0.5\nrule B -> { @", -1},
      {"@", -1},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const Json help = HelpAt(row.text);
    REQUIRE(help.is_null() == (row.active < 0));
    if (help.is_null()) continue;
    CHECK(help["activeParameter"] == row.active);
    CHECK(help["signatures"][0]["label"] ==
          "A1(w in -1..1, a in 1..10, p in 1..10, o in 1..10)");
    CHECK(help["signatures"][0]["parameters"].size() == 4);
    CHECK(help["signatures"][0]["parameters"][1]["label"] == "a");
  }
}

TEST_CASE("Symbols of a file's own alphabet have signatures, too", "[lsp]") {
  const Marked marked(
      "plsc 1\nalphabet x { replaceable F(length: real in 0..10) }\naxiom F\n"
      "rule F -> { F(@");
  Analysis analysis(kTestUri, marked.text);
  const Json help = SignatureHelp(analysis, marked.offset);
  CHECK(help["signatures"][0]["label"] == "F(length in 0..10)");
  const Marked declared("plsc 1\nalphabet x { replaceable F(@length: real) }");
  Analysis other(kTestUri, declared.text);
  CHECK(SignatureHelp(other, declared.offset).is_null());
}

}  // namespace plsc::lsp
