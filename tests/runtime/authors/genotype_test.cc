#include "runtime/authors/genotype.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "compiler/environment_text.h"
#include "compiler/print.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/develop/reference_cases.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

Program Imported(const std::string& text, const ImportOptions& options = {}) {
  const Source source("test", text);
  const auto program =
      ImportAuthorsGenotype(source, GuessAuthorsFormat(text), options);
  if (!program) FAIL(Render(program.diagnostics(), source));
  return *program;
}

std::string CodesOfImport(const std::string& text) {
  const Source source("test", text);
  std::string codes;
  const auto program = ImportAuthorsGenotype(source, GuessAuthorsFormat(text));
  for (const Diagnostic& diagnostic : program.diagnostics()) {
    codes +=
        (codes.empty() ? "" : " ") + std::string(NumberOf(diagnostic.code));
    CHECK(diagnostic.span.end <= text.size());
  }
  return codes;
}

// States in the order in which clauses ask, as an import declares them.
Genotype Comparable(Genotype genotype) {
  genotype.name = "imported";
  std::vector<std::size_t> places(genotype.states.size(), 99);
  std::vector<State> states;
  for (Rule& rule : genotype.rules)
    for (Term& term : rule.clause.terms) {
      std::size_t& place = places[static_cast<std::size_t>(term.state)];
      if (place == 99) {
        place = states.size();
        states.push_back(genotype.states[static_cast<std::size_t>(term.state)]);
      }
      term.state = static_cast<StateId>(place);
    }
  genotype.states = states;
  return genotype;
}

// In the letters' order of their text, where A2 precedes A1 and both B.
Genotype InTheirOrder(Genotype genotype) {
  std::vector<Rule> rules;
  for (const SymbolId letter : AuthorsLetters())
    for (const Rule& rule : genotype.rules)
      if (rule.head == letter) rules.push_back(rule);
  genotype.rules = rules;
  genotype = Comparable(genotype);
  std::stable_sort(
      genotype.rules.begin(), genotype.rules.end(),
      [](const Rule& a, const Rule& b) { return a.head < b.head; });
  return genotype;
}

// Those of the experiments that the samples are of.
void SetAuthorsLimits(Genotype* genotype) {
  const bool is_plastic =
      !genotype->states.empty() && !genotype->rules.front().clause.is_always();
  if (is_plastic) genotype->max_terms = 2;
  genotype->max_rules = is_plastic ? 2 : 1;
}

// Inverse of the lines reader, for tests; `decimals` as Revolve's samples.
std::string LinesOf(const Genotype& genotype, int decimals) {
  std::string text;
  for (const Rule& rule : genotype.rules) {
    text += std::string(AuthorsSymbolOf(rule.head).token) + ' ';
    for (const Symbol& symbol : rule.production) {
      text += AuthorsSymbolOf(symbol.id).token;
      const char* mark = "_";
      for (const double value : AuthorsParameters(symbol)) {
        text += fmt::format("{}{:.{}f}", mark, value, decimals);
        mark = "|";
      }
      text += ' ';
    }
    text += '\n';
  }
  return text;
}

void CheckDevelopment(const test::Json& one, const Genotype& genotype) {
  const Source senses("--env", test::EnvironmentText(one));
  const auto environment = ParseEnvironment(senses, genotype.states);
  REQUIRE(environment);
  const auto active = Regulate(genotype, *environment);
  const auto string = Derive(genotype, active);
  const auto phenotype = Develop(genotype, *environment);
  const auto json = test::Json::parse(
      DevelopmentJson(genotype, *environment, *string, &*phenotype));
  CHECK(json["early"] == one["expected"]["early"]);
  CHECK(json["body"] == one["expected"]["body"]);
}

TEST_CASE("Every sample survives the way to Revolve's export and back",
          "[authors_genotype]") {
  int count = 0;
  for (const std::string& set : test::ReferenceSets())
    for (const test::Json& one : test::ReadReferenceCases(set)) {
      ++count;
      if (!test::IsSampled(static_cast<std::size_t>(count))) continue;
      INFO(one["id"]);
      Genotype genotype = test::CompileText(test::GenotypeText(one)).genotype;
      SetAuthorsLimits(&genotype);
      const auto text = AuthorsGenotypeText(genotype);
      REQUIRE(text);
      const Program program = Imported(*text);
      const Genotype wanted = InTheirOrder(genotype);
      if (genotype.development == DevelopmentSettings{})
        REQUIRE(program.genotype == wanted);
      else
        REQUIRE(program.genotype.rules == wanted.rules);
      // Text to text, too.
      CHECK(*AuthorsGenotypeText(program.genotype) == *text);
      if (count % 10 == 0 && genotype.development == DevelopmentSettings{})
        CheckDevelopment(one, program.genotype);
    }
  CHECK(count == 549);
}

TEST_CASE("Baseline samples survive the way to Revolve's lines and back",
          "[authors_genotype]") {
  for (const test::Json& one : test::ReadReferenceCases("sample_baseline")) {
    INFO(one["id"]);
    Genotype genotype = test::CompileText(test::GenotypeText(one)).genotype;
    // With the digits that doubles need, nothing is lost.
    CHECK(Imported(LinesOf(genotype, 17)).genotype.rules.size() ==
          genotype.rules.size());
    // With Revolve's six, what is left is the rounded number.
    const Program rounded = Imported(LinesOf(genotype, 6));
    for (Rule& rule : genotype.rules)
      for (Symbol& symbol : rule.production)
        for (double& value : symbol.arguments)
          value = std::stod(fmt::format("{:.6f}", value));
    CHECK(rounded.genotype.rules == genotype.rules);
    CHECK(rounded.environments.empty());
  }
}

const std::string kCore =
    "{<Alphabet.CORE_COMPONENT: 'C'>: [[<Alphabet.CORE_COMPONENT: 'C'>, []]";

TEST_CASE("Names and the order of parameters become the paper's",
          "[authors_genotype]") {
  const Program program = Imported(
      kCore + ", [<Alphabet.JOINT_VERTICAL: 'AJ2'>, [0.5, 2.0, 3.0, 4.0]]]}");
  CHECK(PrintSymbol(program.genotype.rules[0].production[1],
                    *program.genotype.alphabet) == "A1(0.5, 4, 2, 3)");
  const Program lines = Imported("C C AJ1_0.5|2|3|4 brainmoveTTS_2|1 \n");
  CHECK(PrintSymbol(lines.genotype.rules[0].production[1],
                    *lines.genotype.alphabet) == "A2(0.5, 4, 2, 3)");
  CHECK(PrintSymbol(lines.genotype.rules[0].production[2],
                    *lines.genotype.alphabet) == "move_ref_N(2, 1)");
}

TEST_CASE("Clauses bring states, and the paper's worlds as environments",
          "[authors_genotype]") {
  const Program program = Imported(
      "{<Alphabet.BLOCK: 'B'>: [[[['hill', '==', True], ['or'], ['hill', "
      "'!=', True]], [[<Alphabet.ADD_LEFT: 'addl'>, []]]], [[], "
      "[[<Alphabet.ADD_LEFT: 'addl'>, []]]]]}");
  CHECK(program.genotype.states.size() == 1);
  CHECK(PrintClause(program.genotype.rules[0].clause, program.genotype) ==
        "hill = True or hill != True");
  CHECK(program.genotype.rules[1].clause.is_always());
  REQUIRE(program.environments.size() == 2);
  CHECK(program.environments[1].name == "tilted5");
  CHECK(program.environments[1].environment.values == std::vector<double>{1});
}

TEST_CASE("Limits are those that Revolve's operators keep to",
          "[authors_genotype]") {
  const auto plastic = [](const std::string& clause, int rules) {
    std::string text = "{<Alphabet.BLOCK: 'B'>: [";
    for (int i = 0; i < rules; ++i)
      text += std::string(i > 0 ? ", " : "") + "[[" + clause +
              "], [[<Alphabet.ADD_LEFT: 'addl'>, []]]]";
    return text + "]}";
  };
  std::string three = "['hill', '==', True]";
  for (int i = 0; i < 2; ++i) three += ", ['or'], ['hill', '==', False]";
  std::string endless = three;
  for (int i = 0; i < 1000; ++i) endless += ", ['or'], ['hill', '==', False]";
  struct Row {
    const char* why;
    std::string text;
    std::optional<int> max_terms;
    std::optional<int> max_rules;
    const char* codes;
  };
  const std::vector<Row> rows = {
      {"plastic", plastic("['hill', '==', True]", 1), 2, 2, ""},
      {"three terms", plastic(three, 2), 3, 2, "W5200"},
      {"three rules", plastic("['hill', '==', True]", 3), 2, 3, "W5200"},
      {"beyond any limit", plastic(endless, 1), std::nullopt, 2, "W5200"},
      {"baseline", kCore + "]}", std::nullopt, 1, ""},
      {"lines", "C C addf B \n", std::nullopt, 1, ""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Genotype genotype = Imported(row.text).genotype;
      CHECK(genotype.max_terms == row.max_terms);
      CHECK(genotype.max_rules == row.max_rules);
      CHECK(CodesOfImport(row.text) == row.codes);
    }
  }
}

TEST_CASE("What Revolve joined in the level season is found, and taken off",
          "[authors_genotype]") {
  const std::string always = "[['hill', '==', False]], ";
  const std::string left = "[<Alphabet.ADD_LEFT: 'addl'>, []]";
  const std::string right = "[<Alphabet.ADD_RIGHT: 'addr'>, []]";
  const std::string core = "[<Alphabet.CORE_COMPONENT: 'C'>, []]";
  const std::string joined = "{<Alphabet.CORE_COMPONENT: 'C'>: [[" + always +
                             "[" + core + ", " + left + ", " + right + "]], [" +
                             always + "[" + core + ", " + right + "]]]}";
  CHECK(CodesOfImport(joined) == "W5200");
  CHECK(Imported(joined).genotype.rules[0].production.size() == 3);
  ImportOptions unjoin;
  unjoin.unjoin = true;
  CHECK(Imported(joined, unjoin).genotype.rules[0].production.size() == 2);
  CHECK(Imported(joined, unjoin).genotype.rules[1].production.size() == 2);
}

TEST_CASE("What is lost, and what is wrong, is said", "[authors_genotype]") {
  struct Row {
    const char* why;
    std::string text;
    const char* codes;
  };
  const std::vector<Row> rows = {
      {"fine", kCore + "]}", ""},
      {"fine lines", "C C addf B \nB ST_0.5 \n", ""},
      {"an empty dictionary", "{}", ""},
      {"an empty rule", "{<Alphabet.BLOCK: 'B'>: []}", "W5200"},
      {"rounded numbers", "B ST_0.500000 \n", "W5200"},
      {"no blank at the end", "B addf ST_0.5\n", "W5200"},
      {"a letter without rule", "B\n", "W5200"},
      {"empty", "", "P5013"},
      {"blanks", " \n\n", "P5013"},
      {"cut off", kCore, "P5200"},
      {"behind the end", kCore + "]} x", "P5200"},
      {"no number", kCore + ", [<Alphabet.SENSOR: 'ST'>, [nan]]]}", "P5200"},
      {"a huge number", kCore + ", [<Alphabet.SENSOR: 'ST'>, [1e999]]]}",
       "P5200"},
      {"an unknown token", kCore + ", [<Alphabet.WHEEL: 'W'>, []]]}", "P2001"},
      {"a missing parameter", kCore + ", [<Alphabet.SENSOR: 'ST'>, []]]}",
       "P2002"},
      {"no whole number", "B brainmoveFTS_1.5|2 \n", "P2003"},
      {"out of range", "B ST_2 addf AJ1_1|0.5|2|2 \n", "P2004 P2004"},
      {"no letter", "addf B \n", "P2007"},
      {"no core", "C addf B \n", "P2008"},
      {"a second core", "C C C \n", "P2008"},
      {"a core elsewhere", "B C \n", "P2008"},
      {"a second rule", "B B \nB B \n", "P5200"},
      {"a broken parameter", "B ST_0.5| ST_x \n", "P5200 P5200"},
      {"a name that plsc cannot have",
       "{<Alphabet.BLOCK: 'B'>: [[[['if', '==', True]], []]]}", "P5200"},
      {"a binary file", std::string("{\0\1", 3), "P5016"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(CodesOfImport(row.text) == row.codes);
    }
  }
}

TEST_CASE("Any beginning of a genotype is refused or read, and nothing worse",
          "[authors_genotype]") {
  const auto cases = test::ReadReferenceCases("sample_plastic");
  const std::string text = *AuthorsGenotypeText(
      test::CompileText(test::GenotypeText(cases[0])).genotype);
  for (std::size_t size = 0; size < text.size(); size += 7)
    CHECK_FALSE(CodesOfImport(text.substr(0, size)).empty());
}

TEST_CASE("What Revolve has no words for is not exported",
          "[authors_genotype]") {
  const auto code = [](const Genotype& genotype) {
    const auto text = AuthorsGenotypeText(genotype);
    return text.diagnostics().empty() ? ""
                                      : NumberOf(text.diagnostics()[0].code);
  };
  CHECK(code(test::Robot("rule C -> { C }")).empty());
  CHECK(code(test::Robot("iterations 4 rule C -> { C }")) == "W5200");
  CHECK(code(test::Robot("max_rules 1 rule C -> { C }")).empty());
  CHECK(code(test::Robot("max_rules 2 rule C -> { C }")) == "W5200");
  CHECK(code(test::Robot("sense t: bool max_terms 2 max_rules 2\n"
                         "rule B -> if t = True then { B }"))
            .empty());
  CHECK(code(test::Robot("sense t: bool max_terms 3\n"
                         "rule B -> if t = True then { B }")) == "W5200");
  CHECK(code(test::Didactic("rule X -> { a }")) == "P5200");
  CHECK(code(test::Robot("rule B -> { B } rule B -> { T(1) }")) == "P5200");
  CHECK(code(test::Robot("sense t: real in 0..1\n"
                         "rule B -> if t > 0.5 then { B }")) == "P5200");
  CHECK(code(test::Robot("sense t: bool rule C -> { C }\n"
                         "rule B -> if t = True then { B }")) == "P5200");
}

// Not timed; by the square of what they list each would take minutes, and the
// messages of the last gigabytes.
TEST_CASE("Texts of Revolve of any length are read or refused",
          "[authors_genotype]") {
  const std::string rule = "[[<Alphabet.ADD_LEFT: 'addl'>, []]]";
  std::string letters = "{";
  std::string conditions = "{<Alphabet.BLOCK: 'B'>: [";
  for (int i = 0; i < 60000; ++i) {
    const char* comma = i == 0 ? "" : ", ";
    letters += fmt::format("{}<Alphabet.X: 'L{}'>: [[[['h', '==', True]], {}]]",
                           comma, i, rule);
    conditions += fmt::format("{}[[['h{}', '==', True]], {}]", comma, i, rule);
  }
  const auto first_of = [](const std::string& text) {
    const auto read =
        ImportAuthorsGenotype(Source("test", text), GuessAuthorsFormat(text));
    REQUIRE_FALSE(read);
    CHECK(read.diagnostics().size() <= kMaxReported + 1);
    return NumberOf(read.diagnostics()[0].code);
  };
  CHECK(first_of(letters + "}") == "P2007");
  CHECK(first_of(conditions + "]}") == "P5200");
  std::string tokens = "B ";
  for (int i = 0; i < 1'000'000; ++i) tokens += "xyz ";
  CHECK(first_of(tokens + "\n") == "P2001");
  std::string numbers = "B ST_";
  for (int i = 0; i < 1'000'000; ++i) numbers += "x|";
  CHECK(first_of(numbers + " \n") == "P5200");
}

}  // namespace
}  // namespace plsc
