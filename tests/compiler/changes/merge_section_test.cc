#include "compiler/changes/merge_section.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

constexpr const char* kTwo = R"(plsc 1
alphabet plasticoding 1
genotype a
rule B -> { T(0.5) }
genotype b
)";

TEST_CASE("SectionsOf cuts at genotypes, or not at all", "[merge_section]") {
  const Source source("file", kTwo);
  const WrittenFile file = ReadItems(source);
  const auto split = SectionsOf(file, true);
  REQUIRE(split.size() == 3);
  CHECK(split[0].key.empty());
  CHECK(split[0].items.size() == 2);
  CHECK(split[1].key == "genotype a");
  CHECK(split[1].items.size() == 2);
  CHECK(SectionsOf(file, false).size() == 1);
}

// The names of what a merge of three texts of one genotype has, in order.
std::string Names(const std::string& base, const std::string& ours,
                  const std::string& theirs) {
  const std::string head = "plsc 1\nalphabet plasticoding 1\n";
  const Source sources[] = {
      {"base", head + base}, {"ours", head + ours}, {"theirs", head + theirs}};
  const WrittenFile files[] = {ReadItems(sources[0]), ReadItems(sources[1]),
                               ReadItems(sources[2])};
  std::string names;
  for (const MatchedItem& item : MatchItems({SectionsOf(files[0], false)[0],
                                             SectionsOf(files[1], false)[0],
                                             SectionsOf(files[2], false)[0]})) {
    if (item.name == "plsc" || item.name == "alphabet") continue;
    names += (names.empty() ? "" : ", ") + item.name;
    if (item.clash) names += '!';
  }
  return names;
}

TEST_CASE("MatchItems finds what stays, and its order", "[merge_section]") {
  struct Row {
    const char* why;
    const char* base;
    const char* ours;
    const char* theirs;
    const char* names;
  };
  const std::vector<Row> rows = {
      {"both added", "let m = 1\n", "let m = 1\nlet z = 1\n",
       "let m = 1\nlet a = 1\n", "let m, let a, let z"},
      {"one deleted", "let m = 1\nlet n = 1\n", "let n = 1\n",
       "let m = 1\nlet n = 1\n", "let n"},
      {"deleted and changed", "let m = 1\n", "", "let m = 2\n", "let m!"},
      {"deleted, and only spelled anew", "let m = 1\n", "",
       "let  m = 1 # one\n", ""},
      {"one side moved an item", "let m = 1\nlet n = 1\n",
       "let n = 1\nlet m = 1\n", "let m = 1\nlet n = 2\n", "let n, let m"},
      {"rules keep their order where a side moved items between",
       "rule B -> { T(0.5) }\nlet m = 1\n", "let m = 1\nrule B -> { T(0.5) }\n",
       "rule B -> { T(0.5) }\nrule B -> { add_left add_left }\nlet m = 1\n",
       "let m, rule 1 of B, rule 2 of B"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Names(row.base, row.ours, row.theirs) == row.names);
      CHECK(Names(row.base, row.theirs, row.ours) == row.names);
    }
  }
}

}  // namespace
}  // namespace plsc
