#include "compiler/alphabet.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "grammar/keywords.h"

namespace plsc {
namespace {

TEST_CASE("plasticoding 1 is Table 1 of the paper", "[alphabet]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  CHECK(alphabet.name() == "plasticoding");
  CHECK(alphabet.version() == 1);
  struct Row {
    SymbolId id;
    const char* name;
    Category category;
    std::size_t parameters;
  };
  using namespace plasticoding;  // NOLINT(google-build-using-namespace)
  const std::vector<Row> rows = {
      {kC, "C", Category::kModule, 0},
      {kB, "B", Category::kModule, 0},
      {kA1, "A1", Category::kModule, 4},
      {kA2, "A2", Category::kModule, 4},
      {kT, "T", Category::kModule, 1},
      {kAddRight, "add_right", Category::kMounting, 0},
      {kAddFront, "add_front", Category::kMounting, 0},
      {kAddLeft, "add_left", Category::kMounting, 0},
      {kMoveBack, "move_back", Category::kMoving, 0},
      {kMoveRight, "move_right", Category::kMoving, 0},
      {kMoveFront, "move_front", Category::kMoving, 0},
      {kMoveLeft, "move_left", Category::kMoving, 0},
      {kMoveRefI, "move_ref_I", Category::kControllerMoving, 2},
      {kMoveRefN, "move_ref_N", Category::kControllerMoving, 2},
      {kAddEdge, "add_edge", Category::kControllerChanging, 1},
      {kLoop, "loop", Category::kControllerChanging, 1},
      {kMutateEdge, "mutate_edge", Category::kControllerChanging, 1},
      {kMutateAmp, "mutate_amp", Category::kControllerChanging, 1},
      {kMutatePer, "mutate_per", Category::kControllerChanging, 1},
      {kMutateOff, "mutate_off", Category::kControllerChanging, 1},
  };
  REQUIRE(alphabet.symbols().size() == rows.size());
  for (const Row& row : rows) {
    CAPTURE(row.name);
    const SymbolInfo& info = alphabet[row.id];
    CHECK(info.name == row.name);
    CHECK(info.category == row.category);
    CHECK(info.is_replaceable == (row.category == Category::kModule));
    CHECK(info.parameters.size() == row.parameters);
    CHECK(alphabet.Find(row.name) == row.id);
    CHECK(IsName(row.name));
    CHECK_FALSE(info.doc.empty());
  }
}

TEST_CASE("Symbols are found by their exact name only", "[alphabet]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  for (const char* name : {"", "c", "A3", "move_ref_i", "C "})
    CHECK_FALSE(alphabet.Find(name));
}

TEST_CASE("Each of a thousand symbols is found, the first of equal names",
          "[alphabet]") {
  std::vector<SymbolInfo> symbols;
  for (int i = 0; i < 1000; ++i)
    symbols.push_back(
        {"s" + std::to_string(i), Category::kTerminal, false, {}, ""});
  symbols.push_back(symbols[7]);
  const Alphabet alphabet("own", 0, std::move(symbols));
  for (int i = 0; i < 1000; ++i)
    REQUIRE(alphabet.Find("s" + std::to_string(i)) == static_cast<SymbolId>(i));
  CHECK_FALSE(alphabet.Find("s1000"));
  const Alphabet copy = alphabet;
  CHECK(copy.Find("s999") == static_cast<SymbolId>(999));
  CHECK_FALSE(Alphabet("own", 0, {}).Find("x"));
}

TEST_CASE("Categories share out all symbols", "[alphabet]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  std::set<SymbolId> all;
  for (int i = 0; i <= static_cast<int>(Category::kTerminal); ++i)
    for (const SymbolId id : alphabet.OfCategory(static_cast<Category>(i)))
      CHECK(all.insert(id).second);
  CHECK(all.size() == alphabet.symbols().size());
}

TEST_CASE("Alphabets are equal when their symbols are", "[alphabet]") {
  const auto make = [](const char* name, double high, const char* doc) {
    Parameter parameter;
    parameter.name = "p";
    parameter.low = 0;
    parameter.high = high;
    parameter.doc = doc;
    return Alphabet("own", 0,
                    {{name, Category::kModule, true, {parameter}, doc}});
  };
  CHECK(make("X", 1, "a") == make("X", 1, "b"));
  CHECK_FALSE(make("X", 1, "") == make("Y", 1, ""));
  CHECK_FALSE(make("X", 1, "") == make("X", 2, ""));
  CHECK_FALSE(make("X", 1, "") == *PlasticodingAlphabet());
}

}  // namespace
}  // namespace plsc
