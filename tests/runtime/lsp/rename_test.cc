#include "runtime/lsp/rename.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "runtime/lsp/rpc.h"
#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

std::string Renamed(const std::string& text, std::string_view at,
                    const std::string& name) {
  Analysis analysis(kTestUri, text);
  const Json edit =
      Rename(analysis, static_cast<std::uint32_t>(text.find(at)), name);
  return Edited(text, edit["changes"][kTestUri]);
}

std::size_t CountOf(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("All places of a name are renamed, and no other", "[lsp]") {
  struct Row {
    const char* why;
    const char* at;
    const char* old_name;
    std::size_t places;
  };
  const std::vector<Row> rows = {
      {"a state", "inclined = True", "inclined", 5},
      {"a state at its declaration", "warmth: real", "warmth", 4},
      {"a constant", "mild", "mild", 3},
      {"a value", "wet }", "wet", 3},
      {"an environment", "flat {", "flat", 2},
      {"a genotype", "gecko", "gecko", 1},
      {"a test", "start", "start", 1},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string renamed = Renamed(kGecko, row.at, "other_name");
      CHECK(CountOf(renamed, "other_name") == row.places);
      CHECK(CountOf(renamed, row.old_name) == 0);
      const auto program = Compile(Source("f", renamed));
      REQUIRE(program);
      CHECK(program->genotype.rules ==
            Compile(Source("f", kGecko))->genotype.rules);
    }
  }
}

TEST_CASE("What several genotypes share is renamed in all", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "genotype one\nrule C -> if a = True then { C }\n"
      "genotype two\nrule C -> if a = False then { C }\n"
      "environment e { a = True }\n";
  CHECK(CountOf(Renamed(text, "a = True then", "steep"), "steep") == 4);
}

TEST_CASE("Own alphabets can be renamed", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet mine { replaceable X(n: int), S; terminal y }\n"
      "axiom S\nrule S -> { X(1) }\nrule X -> { X(1) y }\n";
  const std::string renamed = Renamed(text, "X(1) y", "Long");
  CHECK(CountOf(renamed, "Long") == 4);
  CHECK(Compile(Source("f", renamed)));
}

TEST_CASE("What cannot be renamed is refused and says why", "[lsp]") {
  struct Row {
    const char* why;
    const char* at;
    const char* name;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"a symbol of plasticoding", "add_left", "x",
       "'add_left' is built in and cannot be renamed"},
      {"no name", "if inclined", "x", "expected a name to rename here"},
      {"a keyword", "mild", "rule", "'rule' is a reserved word"},
      {"not an identifier", "mild", "1x",
       "expected a name of letters, digits and '_' that does not begin with a "
       "digit, found '1x'"},
      {"empty", "mild", "",
       "expected a name of letters, digits and '_' that does not begin with a "
       "digit, found ''"},
      {"taken by another constant", "mild", "half",
       "cannot rename to 'half': constant 'half' is declared twice"},
      {"taken by another state", "warmth", "inclined",
       "cannot rename to 'inclined': state 'inclined' is declared twice"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK_THROWS_WITH(Renamed(kGecko, row.at, row.name), row.message);
    }
  }
}

TEST_CASE("Broken files are not renamed in", "[lsp]") {
  Analysis analysis(kTestUri, "plsc 1\nsense a: bool\nrule");
  CHECK_THROWS_WITH(Rename(analysis, 13, "b"),
                    "cannot rename while the file has errors: mend them first");
  CHECK_THROWS_AS(PrepareRename(analysis, 13), Fault);
}

TEST_CASE("Before a rename the name is shown", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const Json prepared = PrepareRename(
      analysis, static_cast<std::uint32_t>(analysis.text().find("mild") + 2));
  CHECK(prepared["placeholder"] == "mild");
  CHECK(prepared["range"]["start"] == Json({{"line", 7}, {"character", 4}}));
}

}  // namespace plsc::lsp
