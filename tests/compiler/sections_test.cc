#include "compiler/sections.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "compiler/format.h"
#include "grammar/parse.h"

namespace plsc {
namespace {

// Something of every kind of item, before and behind the genotypes' names.
constexpr const char* kZoo =
    "plsc 1\n"
    "sense hot: bool\n"
    "let w = 0.25\n"
    "environment cold { hot = False }\n"
    "rule T -> { add_left T(w) }  # shared\n"
    "genotype gecko\n"
    "alphabet plasticoding 1\n"
    "axiom C\n"
    "rule C -> if hot = True then { C T(w) }\n"
    "test bare in cold after 1 -> body C\n"
    "genotype ladder\n"
    "alphabet own { replaceable X, T(r: real); terminal add_left, u(n: int) }\n"
    "axiom X\n"
    "iterations 1\n"
    "sense ground: { dry, wet }\n"
    "environment wet { hot = True, ground = wet }\n"
    "rule X -> { u(2) X }\n"
    "test grows in wet -> { u X }\n";

TEST_CASE("Each genotype has what is shared and what is its own",
          "[sections]") {
  const Source source("zoo", kZoo);
  const ParseResult parsed = Parse(source);
  const std::vector<ast::File> sections = SplitIntoSections(parsed.file);
  REQUIRE(sections.size() == 2);
  for (const ast::File& section : sections) {
    CHECK(section.version.end > 0);
    CHECK(section.lets.size() == 1);
    CHECK(section.rules.size() == 2);
    CHECK(section.rules[0].symbols.first == 0);
    CHECK(section.tests.size() == 1);
    CHECK(section.genotypes.size() == 1);
  }
  CHECK(sections[0].environments.size() == 1);
  CHECK(sections[1].environments.size() == 2);
  CHECK(sections[1].declarations.size() == 4);
  CHECK(sections[1].Text(sections[1].parameters[1].name) == "n");
  CHECK(sections[0].Text(sections[0].genotypes[0].name) == "gecko");
}

TEST_CASE("What is shared must fit every genotype", "[sections]") {
  // `cold` lacks a value for the state that only the second one senses.
  const Result<std::vector<Program>> all = CompileAll(Source("zoo", kZoo));
  REQUIRE_FALSE(all);
  REQUIRE(all.diagnostics().size() == 1);
  CHECK(all.diagnostics()[0].code == Code::kWrongEnvironment);
  CHECK(all.diagnostics()[0].message ==
        "environment 'cold' lacks a value for 'ground'");
}

std::string FittingZoo() {
  std::string text = kZoo;
  const std::string shared = "environment cold { hot = False }\n";
  text.erase(text.find(shared), shared.size());
  text.insert(text.find("axiom C"), shared);
  return text;
}

TEST_CASE("Sections compile to the programs of files of their own",
          "[sections]") {
  const auto all = CompileAll(Source("zoo", FittingZoo()));
  REQUIRE(all);
  REQUIRE(all->size() == 2);
  CHECK((*all)[0].genotype.name == "gecko");
  CHECK((*all)[1].genotype.alphabet->name() == "own");
  const auto alone = Compile(
      Source("gecko",
             "plsc 1 genotype gecko sense hot: bool alphabet plasticoding 1 "
             "environment cold { hot = False } axiom C "
             "rule C -> if hot = True then { C T(0.25) } "
             "rule T -> { add_left T(0.25) } "
             "test bare in cold after 1 -> body C"));
  REQUIRE(alone);
  CHECK((*all)[0] == *alone);
}

TEST_CASE("Spans of a section's map are of the whole text", "[sections]") {
  const Source source("zoo", FittingZoo());
  const auto all = CompileAllWithMap(source);
  REQUIRE(all);
  const auto text = [&](Span span) {
    return std::string(source.text().substr(span.begin, span.end - span.begin));
  };
  const SourceMap& map = (*all)[1].map;
  CHECK(text(map.genotype) == "ladder");
  CHECK(text(map.iterations) == "1");
  CHECK(text(map.axiom) == "X");
  REQUIRE(map.tests.size() == 1);
  CHECK(text(map.tests[0].name) == "grows");
  CHECK(text(map.tests[0].symbols[0]) == "u");
  CHECK(text(map.rules[0].symbols[0]) == "u(2)");
}

TEST_CASE("A single genotype's name may stand anywhere", "[sections]") {
  const auto program = Compile(
      Source("a", "plsc 1 alphabet plasticoding 1 rule B -> { B } genotype a"));
  REQUIRE(program);
  CHECK(program->genotype.rules.size() == 1);
  CHECK(program->genotype.name == "a");
}

TEST_CASE("Formatting keeps sections apart and what is shared first",
          "[sections]") {
  const Result<std::string> text = Format(Source("zoo", FittingZoo()), {});
  REQUIRE(text);
  const auto at = [&](const char* part) { return text->find(part); };
  CHECK(at("rule T ->") < at("genotype gecko"));
  CHECK(at("# shared") < at("genotype gecko"));
  CHECK(at("genotype gecko") < at("rule C ->"));
  CHECK(at("test bare") < at("\n\ngenotype ladder\nalphabet own"));
  CHECK(at("genotype ladder") < at("environment wet"));
}

TEST_CASE("What is shared is not copied without end", "[sections]") {
  std::string text = "plsc 1 alphabet plasticoding 1\n";
  for (int i = 0; i < 1000; ++i) text += "rule B -> { add_left B }\n";
  for (int i = 0; i < 1000; ++i)
    text += "genotype g" + std::to_string(i) + "\n";
  const auto all = CompileAll(Source("zoo", text));
  REQUIRE(all.diagnostics().size() == 1);
  CHECK(all.diagnostics()[0].code == Code::kLimit);
}

}  // namespace
}  // namespace plsc
