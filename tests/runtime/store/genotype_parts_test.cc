#include "runtime/store/genotype_parts.h"

#include <catch2/catch.hpp>
#include <string>

#include "compiler/print.h"
#include "runtime/evolve/breed.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

std::string Join(const GenotypeParts& parts, const std::string& name) {
  std::string text = parts.before_name + name + parts.after_name;
  for (const std::string& rule : parts.rules) text += "\n" + rule;
  return text;
}

}  // namespace

TEST_CASE("The parts of a genotype make its text", "[genotype_parts]") {
  Experiment experiment = test::StoredExperiment();
  for (int id = 1; id <= 20; ++id) {
    const Genotype genotype = CreateFirst(experiment, id).genotype;
    const std::string text = Print(genotype);
    const GenotypeParts parts = SplitGenotype(text, genotype.name);
    CHECK(Join(parts, genotype.name) == text);
    CHECK(parts.rules.size() == genotype.rules.size());
    for (const std::string& rule : parts.rules)
      CHECK(rule.substr(0, 5) == "rule ");
    CHECK(parts.before_name == "plsc 1\n\ngenotype ");
  }
}

TEST_CASE("What is odd about a genotype stays", "[genotype_parts]") {
  Genotype genotype = CreateFirst(test::StoredExperiment(), 1).genotype;
  SECTION("no rules") {
    genotype.rules.clear();
  }
  SECTION("a name like a rule") {
    genotype.name = "rule";
  }
  SECTION("a name like a keyword") {
    genotype.name = "genotype";
  }
  const std::string text = Print(genotype);
  CHECK(Join(SplitGenotype(text, genotype.name), genotype.name) == text);
}

}  // namespace plsc
