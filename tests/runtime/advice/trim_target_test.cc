#include "runtime/advice/trim_target.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

MappedProgram MappedTarget(const std::string& rest) {
  const auto mapped = CompileWithMap(
      Source("test", "plsc 1\nalphabet plasticoding 1\niterations 1\n" + rest));
  REQUIRE(mapped);
  return *mapped;
}

TEST_CASE("A target takes what develops the same, and nothing else",
          "[trim_target]") {
  const MappedProgram mapped = MappedTarget(
      "sense a: bool\nsense b: bool\n"
      "rule C -> if a = True or b = True then { C B add_left B }\n");
  const auto target = MakeTrimTarget(mapped);
  REQUIRE(target);
  CHECK(target->regimes.size() == 2);
  CHECK(target->developed.size() == 2);

  Genotype shorter = mapped.program.genotype;
  shorter.rules[0].production.erase(shorter.rules[0].production.begin() + 1);
  const TrimTry fine = TryGenotype(*target, shorter, PieceKind::kSymbol);
  REQUIRE(fine.target);
  CHECK(fine.target->current == shorter);
  CHECK(fine.work >= 3);

  Genotype none = mapped.program.genotype;
  none.rules.clear();
  CHECK_FALSE(TryGenotype(*target, none, PieceKind::kRule).target);

  // Both environments of the one regime must be looked at.
  Genotype other = mapped.program.genotype;
  other.rules[0].clause.terms.pop_back();
  other.rules[0].clause.connectives.clear();
  CHECK_FALSE(TryGenotype(*target, other, PieceKind::kTerm).target);
}

TEST_CASE("A target keeps passing tests", "[trim_target]") {
  const MappedProgram mapped = MappedTarget(
      "rule C -> { C B add_left B }\n"
      "test passes -> { C B add_left B }\ntest fails -> { C }\n");
  const auto target = MakeTrimTarget(mapped);
  REQUIRE(target);
  CHECK(target->tests == std::vector<std::size_t>{0});
  Genotype shorter = mapped.program.genotype;
  shorter.rules[0].production.erase(shorter.rules[0].production.begin() + 1);
  CHECK_FALSE(TryGenotype(*target, shorter, PieceKind::kSymbol).target);
}

TEST_CASE("A genotype that would outgrow its limit is no other",
          "[trim_target]") {
  const MappedProgram mapped = MappedTarget(
      "sense a: bool\nrule C -> { C B }\n"
      "rule B -> if a = True and a = False then { B B }\n");
  const auto target = MakeTrimTarget(mapped);
  REQUIRE(target);
  Genotype loose = mapped.program.genotype;
  loose.rules[1].clause = {};
  loose.development.iterations = 40;
  CHECK_FALSE(TryGenotype(*target, loose, PieceKind::kTerm).target);
}

}  // namespace
}  // namespace plsc
