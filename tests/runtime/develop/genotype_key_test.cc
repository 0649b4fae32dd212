#include "runtime/develop/genotype_key.h"

#include <catch2/catch.hpp>

#include "compiler/print.h"
#include "compiler/random_genotype.h"
#include "compiler/verify.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

const std::string kHead = "plsc 1\ngenotype one\nalphabet plasticoding 1\n";
const std::string kBase = kHead +
                          "sense hot: bool\nsense ground: { dry, wet }\n"
                          "rule B -> if ground = wet then { T(0.5) B }\n";

Key KeyOfText(const std::string& text) {
  return GenotypeKey(test::CompileText(text).genotype);
}

TEST_CASE("A genotype's key does not depend on how it is written",
          "[genotype_key]") {
  const Key key = KeyOfText(kBase);
  for (const std::string& same :
       {std::string("plsc 1 # a\nalphabet plasticoding 1 genotype two\n"
                    "rule B->if ground=wet then{T(5e-1)B}\n"
                    "sense hot: bool sense ground: { dry, wet }"),
        kHead + "sense ground: { wet, dry }\nsense hot: bool\niterations 3\n"
                "let half = 0.50\naxiom C\n"
                "rule B -> if ground = wet then { T(half) B }\n"
                "environment x { hot = True, ground = wet }\n"}) {
    CAPTURE(same);
    CHECK(KeyOfText(same) == key);
  }
}

TEST_CASE("A genotype's key depends on all that is inherited",
          "[genotype_key]") {
  const Key key = KeyOfText(kBase);
  const auto replaced = [](const std::string& from, const std::string& to) {
    std::string text = kBase;
    text.replace(text.find(from), from.size(), to);
    return KeyOfText(text);
  };
  CHECK(replaced("0.5", "0.25") != key);
  CHECK(replaced("T(0.5) B", "B T(0.5)") != key);
  CHECK(replaced("= wet then", "= dry then") != key);
  CHECK(replaced("= wet then", "!= wet then") != key);
  CHECK(replaced("hot", "cold") != key);
  CHECK(KeyOfText(kBase + "iterations 4\n") != key);
  CHECK(KeyOfText(kBase + "max_rules 4\n") != key);
}

TEST_CASE("Canonical genotypes are correct, and their own canonical form",
          "[genotype_key]") {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const Genotype genotype = testing::RandomProgram(seed).genotype;
    const Genotype canonical = Canonical(genotype);
    CHECK(Verify(canonical).empty());
    CHECK(Canonical(canonical) == canonical);
    CHECK(GenotypeKey(canonical) == GenotypeKey(genotype));
  }
}

}  // namespace
}  // namespace plsc
