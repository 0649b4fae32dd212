#include "runtime/advice/trim.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "compiler/print.h"
#include "runtime/develop/develop.h"
#include "runtime/vary/initialise.h"
#include "runtime/vary/mutate.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/develop/reference_cases.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

const std::string kHead = "plsc 1\nalphabet plasticoding 1\n";

std::string Trimmed1(const std::string& text) {
  const Source source("test", text);
  const auto trimmed = Trim(source);
  if (!trimmed) FAIL(Render(trimmed.diagnostics(), source));
  CHECK(trimmed->is_complete);
  return trimmed->text;
}

TEST_CASE("Trim leaves out what changes no robot, and keeps the rest as it is",
          "[trim]") {
  struct Row {
    const char* why;
    const char* text;
    const char* trimmed;
  };
  const std::vector<Row> rows = {
      {"nothing to leave out", "rule C -> { C add_left B } # fine\n",
       "rule C -> { C add_left B } # fine\n"},
      {"modules without a slot",
       "iterations 1\nrule C -> { C B add_left B T(1) "
       "}\n",
       "iterations 1\nrule C -> { C add_left B }\n"},
      {"a slot that is overwritten",
       "iterations 1\nrule C -> {\n  C\n  add_left  # never used\n"
       "  add_right # used\n  B\n}\n",
       "iterations 1\nrule C -> {\n  C\n  add_right # used\n  B\n}\n"},
      {"there and back",
       "iterations 1\nrule C -> { C add_left B move_left move_back add_right B "
       "}\n",
       "iterations 1\nrule C -> { C add_left B add_right B }\n"},
      {"a rule that nothing calls, with its comment",
       "iterations 1\nrule C -> { C add_left B }\n\n# of no use\nrule T -> { "
       "add_left B }\n\nenvironment any { }\n",
       "iterations 1\nrule C -> { C add_left B }\n\nenvironment any { }\n"},
      {"a rule that is never active",
       "sense hot: bool\niterations 1\nrule C -> { C add_left B }\n"
       "rule B -> if hot = True and hot = False then { T(1) }\n",
       "sense hot: bool\niterations 1\nrule C -> { C add_left B }\n"},
      {"a clause that always holds",
       "sense hot: bool\niterations 1\n"
       "rule C -> if hot = True or hot = False then { C add_left B }\n",
       "sense hot: bool\niterations 1\nrule C -> { C add_left B }\n"},
      {"a term that says nothing more",
       "sense hot: bool\nsense wet: bool\niterations 1\n"
       "rule C -> if hot = True and wet = True or hot = True # both\n"
       "then { C add_left B }\n",
       "sense hot: bool\nsense wet: bool\niterations 1\n"
       "rule C -> if hot = True # both\nthen { C add_left B }\n"},
      {"all of it", "rule B -> { add_left B }\n", ""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string once = Trimmed1(kHead + row.text);
      CHECK(once == kHead + row.trimmed);
      CHECK(Trimmed1(once) == once);
    }
  }
}

TEST_CASE("A clause stays where its rule would be active for nothing",
          "[trim]") {
  // Where `inclined` is False the front is taken, so that B finds no slot.
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense inclined: bool\n"
      "rule C -> if inclined = False then { C add_front T(0.5) }\n"
      "rule C -> if inclined = True then { C add_front B }\n"
      "rule C -> { C }\n";
  const auto trimmed = Trim(Source("x.pls", text));
  REQUIRE(trimmed);
  CHECK(trimmed->genotypes[0].after.terms == 2);
}

TEST_CASE("Two clauses of one regime are told apart once a term is gone",
          "[trim]") {
  // `a or b` is one regime; without `b` the robot of (a=False, b=True) would
  // be another.
  const std::string text = kHead +
                           "sense a: bool\nsense b: bool\niterations 1\n"
                           "rule C -> if a = True or b = True then { C "
                           "add_left B }\n";
  CHECK(Trimmed1(text) == text);
}

std::vector<NamedEnvironment> Lived(const Genotype& genotype,
                                    const std::vector<double>& inclined) {
  std::vector<NamedEnvironment> lived;
  for (const double value : inclined) {
    Environment environment{std::vector<double>(genotype.states.size(), 0)};
    environment.values[0] = value;
    lived.push_back({value > 0 ? "hill" : "plain", environment});
  }
  return lived;
}

TEST_CASE("Only environments that are lived in count, if they are named",
          "[trim]") {
  const std::string text =
      kHead +
      "sense inclined: bool\nsense hot: bool\niterations 1\n"
      "rule C -> if inclined = False and hot = False then { C add_left B }\n"
      "rule C -> if inclined = True then { C add_front B }\n"
      "rule C -> if hot = True then { C add_right B }\n";
  const Source source("test", text);
  const Genotype genotype = test::CompileText(text).genotype;
  TrimOptions options;
  options.lived = {Lived(genotype, {0, 1})};
  const auto seasons = Trim(source, options);
  REQUIRE(seasons);
  // It is never hot.
  CHECK(seasons->text ==
        kHead +
            "sense inclined: bool\nsense hot: bool\niterations 1\n"
            "rule C -> if inclined = False then { C add_left B }\n"
            "rule C -> if inclined = True then { C add_front B }\n");
  REQUIRE(seasons->genotypes[0].proof.size() == 2);
  CHECK(seasons->genotypes[0].proof[0].named ==
        std::vector<std::string>{"plain"});
  options.lived = {Lived(genotype, {1})};
  const auto hill = Trim(source, options);
  REQUIRE(hill);
  CHECK(hill->text ==
        kHead +
            "sense inclined: bool\nsense hot: bool\niterations 1\n"
            "rule C -> { C add_front B }\n");
  CHECK(hill->genotypes[0].proof.size() == 1);
}

TEST_CASE("Random genotypes stay what they are where they live", "[trim]") {
  constexpr std::uint64_t kSeed = 20261130;
  GenotypeOptions drawn;
  drawn.states.push_back({"hot", StateType::kBool, 0, 0, {}});
  std::size_t more = 0;
  for (std::uint64_t i = 0; i < test::Sampled(12U); ++i) {
    INFO("seed " << kSeed << ", genotype " << i);
    Rng rng({kSeed, 0, i, Purpose::kInitialise});
    Genotype genotype = Initialise(drawn, rng);
    genotype.name = "drawn";
    const Source source("test", Print(genotype));
    TrimOptions options;
    options.lived = {Lived(genotype, {0, 1})};
    const auto trimmed = Trim(source, options);
    REQUIRE(trimmed);
    const Genotype after = test::CompileText(trimmed->text).genotype;
    // By development, not by the trimmer's own proof.
    for (const NamedEnvironment& one : options.lived[0])
      CHECK(Develop(after, one.environment) ==
            Develop(genotype, one.environment));
    const auto everywhere = Trim(source);
    REQUIRE(everywhere);
    CHECK(trimmed->text.size() <= everywhere->text.size());
    more += everywhere->text.size() - trimmed->text.size();
  }
  CHECK(more > 0);
}

TEST_CASE("What the file expects of itself goes on to hold", "[trim]") {
  const std::string text = kHead +
                           "iterations 1\nrule C -> { C B add_left B }\n"
                           "test string -> { C B add_left B }\n";
  CHECK(Trimmed1(text) == text);
  const std::string failing = kHead +
                              "iterations 1\nrule C -> { C B add_left B }\n"
                              "test string -> { C }\n";
  CHECK(Trimmed1(failing).find("{ C add_left B }") != std::string::npos);
}

TEST_CASE("What belongs to several genotypes goes from all or none", "[trim]") {
  const std::string shared = kHead +
                             "iterations 1\n"
                             "rule B -> { add_left B T(1) }\n"
                             "genotype a\nrule C -> { C B add_front B }\n"
                             "genotype b\niterations 2\n"
                             "rule C -> { C B add_front B move_front }\n";
  // iterations stands twice for b, so give it to each instead.
  const std::string text = kHead +
                           "rule B -> { B add_left B }\n"
                           "genotype a\niterations 1\n"
                           "rule C -> { C B add_front B }\n"
                           "genotype b\niterations 2\n"
                           "rule C -> { C B add_front B move_front }\n";
  CHECK_FALSE(Compile(Source("x", shared)));
  TrimOptions only_a;
  only_a.only = 0;
  const Source source("test", text);
  const auto a = Trim(source, only_a);
  REQUIRE(a);
  // Rule B does nothing in a, but b needs it; b's own rule is not touched.
  CHECK(a->text == kHead +
                       "rule B -> { B add_left B }\n"
                       "genotype a\niterations 1\n"
                       "rule C -> { C add_front B }\n"
                       "genotype b\niterations 2\n"
                       "rule C -> { C B add_front B move_front }\n");
  REQUIRE(a->genotypes.size() == 2);
  CHECK(AreSame(a->genotypes[1].proof));
}

TEST_CASE("Trim refuses what cannot be developed everywhere", "[trim]") {
  const auto code = [](const std::string& text) {
    const auto trimmed = Trim(Source("test", kHead + text));
    REQUIRE_FALSE(trimmed);
    return NumberOf(trimmed.diagnostics().front().code);
  };
  CHECK(code("iterations 30\nrule C -> { C B }\nrule B -> { B B }\n") ==
        "P4001");
  CHECK(code("sense hot: bool\niterations 30\nrule C -> { C B }\n"
             "rule B -> if hot = True then { B B }\n") == "P4001");
  CHECK(code("rule C -> {\n") == "P1107");
  std::string many;
  std::string clause;
  for (int i = 0; i < 17; ++i) {
    many += fmt::format("sense s{}: bool\n", i);
    clause += fmt::format("{} s{} = True", i == 0 ? "if" : " and", i);
  }
  CHECK(code(many + "rule C -> " + clause + " then { C }\n") == "P4003");
}

TEST_CASE("Trim knows its limit of work, and says so", "[trim]") {
  const std::string text =
      kHead + "iterations 1\nrule C -> { C B B B B add_left B }\n";
  TrimOptions options;
  options.max_work = 1;
  const auto trimmed = Trim(Source("test", text), options);
  REQUIRE(trimmed);
  CHECK_FALSE(trimmed->is_complete);
  CHECK(AreSame(trimmed->genotypes.front().proof));
}

TEST_CASE("Own alphabets keep their string", "[trim]") {
  const std::string text =
      "plsc 1\nalphabet abc { replaceable X, Y; terminal a }\naxiom X\n"
      "iterations 2\nrule X -> { X a }\nrule Y -> { a a }\n";
  CHECK(Trimmed1(text) ==
        "plsc 1\nalphabet abc { replaceable X, Y; terminal a }\naxiom X\n"
        "iterations 2\nrule X -> { X a }\n");
}

// Every phenotype of the authors' cases, developed anew from the text.
void CheckSampleSet(const std::string& set, std::size_t step) {
  const auto cases = test::ReadReferenceCases(set);
  for (std::size_t i = 0; i < cases.size(); i += step * test::kSparser) {
    const std::string text = test::GenotypeText(cases[i]);
    const Genotype before = test::CompileText(text).genotype;
    const auto trimmed = Trim(Source("test", text));
    REQUIRE(trimmed);
    const Genotype after = test::CompileText(trimmed->text).genotype;
    const int environments = 1 << before.states.size();
    for (int bits = 0; bits < environments; ++bits) {
      Environment environment;
      for (std::size_t s = 0; s < before.states.size(); ++s)
        environment.values.push_back(bits >> s & 1);
      INFO(cases[i]["id"] << " " << bits);
      CHECK(Develop(before, environment) == Develop(after, environment));
    }
    CHECK(Trimmed1(trimmed->text) == trimmed->text);
  }
}

TEST_CASE("The authors' genotypes develop the same, trimmed", "[trim]") {
  CheckSampleSet("sample_rare", 1);
  CheckSampleSet("sample_plastic", 100);
  CheckSampleSet("sample_two_states", 80);
}

TEST_CASE("All of the authors' genotypes develop the same, trimmed",
          "[trim][slow]") {
  for (const std::string& set : test::ReferenceSets()) CheckSampleSet(set, 4);
}

}  // namespace
}  // namespace plsc
