#include "compiler/check_symbols.h"

#include <catch2/catch.hpp>
#include <string>

#include "compiler/check.h"
#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::CodesOf;

TEST_CASE("Symbols of productions are checked one by one", "[check_symbols]") {
  struct Row {
    const char* rule;
    const char* codes;
  };
  const std::vector<Row> rows = {
      {"B -> { A1(-1, 1, 10, 1e0) }", ""},
      {"B -> { A1(-1, 1, 10) }", "P2002"},
      {"B -> { A1(-1, 1, 10, 1, 1) }", "P2002"},
      {"B -> { T B(0) T(0) }", "P2002 P2002"},
      {"B -> { A1(-1.1, 0.9, 10.1, 11) }", "P2004 P2004 P2004 P2004"},
      {"B -> { mutate_amp(-1e308) }", ""},
      {"B -> { move_ref_I(1, 9007199254740992) }", ""},
      {"B -> { move_ref_I(1, 9007199254740993) }", ""},
      {"B -> { move_ref_I(1, 9007199254740994) }", "P2003"},
      {"B -> { move_ref_I(-1, 1.0) }", "P2004 P2003"},
      {"add_left -> { B }", "P2007"},
      {"C -> { C C }", "P2008"},
      {"C -> { B }", "P2008"},
      {"C -> { B C }", "P2008 P2008"},
      {"T -> { C }", "P2008"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.rule) {
      CHECK(CodesOf(std::string("plsc 1 alphabet plasticoding 1 rule ") +
                    row.rule) == row.codes);
    }
  }
}

TEST_CASE("A signature shows names and ranges", "[check_symbols]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  CHECK(Signature(alphabet[plasticoding::kA1]) ==
        "A1(w in -1..1, a in 1..10, p in 1..10, o in 1..10)");
  CHECK(Signature(alphabet[plasticoding::kMoveRefI]) ==
        "move_ref_I(t in 1 or more, d in 1 or more)");
  CHECK(Signature(alphabet[plasticoding::kMutateAmp]) == "mutate_amp(m)");
  CHECK(Signature(alphabet[plasticoding::kB]) == "B");
}

}  // namespace
}  // namespace plsc
