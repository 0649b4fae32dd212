#include "runtime/advice/trim_pieces.h"

#include <catch2/catch.hpp>

#include "compiler/print.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

MappedProgram Mapped(const std::string& text) {
  const auto mapped = CompileWithMap(Source("test", text));
  REQUIRE(mapped);
  return *mapped;
}

const std::string kText =
    "plsc 1\nalphabet plasticoding 1\nsense a: bool\nsense b: bool\n"
    "sense c: bool\n"
    "rule C -> if a = True or b = True and c = True then { C add_left B }\n";

std::string ClauseWithout(const std::vector<std::size_t>& terms) {
  const MappedProgram mapped = Mapped(kText);
  const Pieces pieces = PiecesOf({&mapped, 1});
  Kept kept(pieces.all.size(), true);
  for (const std::size_t term : terms)
    kept[pieces.of[0][0].terms[term]] = false;
  const auto genotype = KeepPieces(mapped.program.genotype, pieces.of[0], kept);
  REQUIRE(genotype);
  return PrintClause(genotype->rules[0].clause, *genotype);
}

TEST_CASE("Terms that stay keep their groups", "[trim_pieces]") {
  CHECK(ClauseWithout({}) == "a = True or b = True and c = True");
  CHECK(ClauseWithout({0}) == "b = True and c = True");
  CHECK(ClauseWithout({1}) == "a = True or c = True");
  CHECK(ClauseWithout({2}) == "a = True or b = True");
  CHECK(ClauseWithout({1, 2}) == "a = True");
  CHECK(ClauseWithout({0, 1, 2}).empty());
}

TEST_CASE("A production keeps a symbol, and that of C its C", "[trim_pieces]") {
  const MappedProgram mapped = Mapped(kText);
  const Pieces pieces = PiecesOf({&mapped, 1});
  const RulePieces& rule = pieces.of[0][0];
  CHECK(pieces.all.size() == 1 + 3 + 3);
  Kept kept(pieces.all.size(), true);
  kept[rule.symbols[0]] = false;
  CHECK_FALSE(KeepPieces(mapped.program.genotype, pieces.of[0], kept));
  kept[rule.symbols[1]] = kept[rule.symbols[2]] = false;
  CHECK_FALSE(KeepPieces(mapped.program.genotype, pieces.of[0], kept));
  kept[rule.rule] = false;
  CHECK(KeepPieces(mapped.program.genotype, pieces.of[0], kept)->rules.empty());
}

}  // namespace
}  // namespace plsc
