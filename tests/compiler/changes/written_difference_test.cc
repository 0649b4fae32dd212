#include "compiler/changes/written_difference.h"

#include <catch2/catch.hpp>

#include "compiler/changes/merge_parts.h"

namespace plsc {
namespace {

const std::string kDifferenceHead = "plsc 1\nalphabet plasticoding 1\n";

// "+let a ~rule 1 of B[T(1)>T(2)]": marks + - > ~, and changed parts.
std::string Shown(const std::vector<SectionChange>& sections) {
  std::string text;
  for (const SectionChange& section : sections) {
    if (!section.genotype.empty()) text += section.genotype + ": ";
    for (const ItemChange& change : section.items) {
      text += "+->~"[static_cast<std::size_t>(change.kind)] + change.name;
      for (const PartChange& part : change.parts)
        if (part.before != part.after)
          text += '[' + (part.before ? PartText(*part.before) : "") + '>' +
                  (part.after ? PartText(*part.after) : "") + ']';
      text += ' ';
    }
  }
  return text;
}

TEST_CASE("CompareTexts tells what changed", "[written_difference]") {
  struct Row {
    const char* why;
    std::string before;
    std::string after;
    const char* shown;
  };
  const std::vector<Row> rows = {
      {"layout and comments", "rule B -> { T(0.5) }\n",
       "# x\nrule B -> {\n  T(0.50)\n}\n", ""},
      {"an item added", "", "let a = 1\n", "+let a "},
      {"an item removed", "let a = 1\n", "", "-let a "},
      {"an item changed", "let a = 1\n", "let a = 2\n", "~let a "},
      {"order of items", "let a = 1\nlet b = 1\n", "let b = 1\nlet a = 1\n",
       ""},
      {"an argument", "rule B -> { B T(0.1) }\n", "rule B -> { B T(0.2) }\n",
       "~rule 1 of B[T(0.1)>T(0.2)] "},
      {"a symbol more and one less", "rule B -> { B add_left B T(0.1) }\n",
       "rule B -> { add_left B T(0.1) T(0.2) }\n",
       "~rule 1 of B[B>][>T(0.2)] "},
      {"a rule added before", "rule B -> { T(0.1) }\n",
       "rule B -> if a = 1 then { add_left }\nrule B -> { T(0.1) }\n",
       "+rule 1 of B[>add_left] "},
      {"a rule moved",
       "rule B -> { T(0.1) }\nrule B -> if a = 1 then { add_left }\n",
       "rule B -> if a = 1 then { add_left }\nrule B -> { T(0.1) }\n",
       ">rule 2 of B "},
      {"a genotype of several", "genotype a\ngenotype b\niterations 1\n",
       "genotype a\ngenotype b\niterations 2\n", "b: ~iterations "},
      {"the name of the only one", "genotype a\n", "genotype b\n",
       "~genotype "},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Shown(CompareTexts(Source("old", kDifferenceHead + row.before),
                               Source("new", kDifferenceHead + row.after))) ==
            row.shown);
    }
  }
}

TEST_CASE("Changes have lines", "[written_difference]") {
  const auto changes =
      CompareTexts(Source("old", kDifferenceHead + "let a = 1\nlet b = 1\n"),
                   Source("new", kDifferenceHead + "\nlet a = 2\nlet c = 1\n"));
  REQUIRE(changes.size() == 1);
  REQUIRE(changes[0].items.size() == 3);
  CHECK(changes[0].items[0].old_line == 3);
  CHECK(changes[0].items[0].new_line == 4);
  CHECK(changes[0].items[1].old_line == 0);  // c
  CHECK(changes[0].items[2].new_line == 0);  // b
}

TEST_CASE("CompareGenotypes compares what has other names",
          "[written_difference]") {
  const Source zoo("zoo", kDifferenceHead +
                              "genotype a\niterations 1\n"
                              "genotype b\niterations 2\n");
  CHECK(Shown(CompareGenotypes({zoo, "a"}, {zoo, "b"})) ==
        "b: ~genotype ~iterations ");
  CHECK(CompareGenotypes({zoo, "a"}, {zoo, "a"}).empty());
}

}  // namespace
}  // namespace plsc
