#include "runtime/lsp/descriptions.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("Every built-in symbol and parameter is described", "[lsp]") {
  for (const SymbolInfo& symbol : PlasticodingAlphabet()->symbols()) {
    INFO(symbol.name);
    CHECK_FALSE(symbol.doc.empty());
    const std::string text = DescribeSymbol(symbol);
    CHECK(text.find(symbol.doc) != std::string::npos);
    for (const Parameter& parameter : symbol.parameters) {
      CHECK_FALSE(parameter.doc.empty());
      CHECK(text.find(parameter.doc) != std::string::npos);
    }
  }
}

TEST_CASE("Signatures are written as declarations", "[lsp]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  CHECK(SignatureOf(alphabet[plasticoding::kC]) == "C");
  CHECK(SignatureOf(alphabet[plasticoding::kA1]) ==
        "A1(w in -1..1, a in 1..10, p in 1..10, o in 1..10)");
  CHECK(SignatureOf(alphabet[plasticoding::kMoveRefI]) ==
        "move_ref_I(t in 1 or more, d in 1 or more)");
  CHECK(SignatureOf(alphabet[plasticoding::kMutateAmp]) == "mutate_amp(m)");
  CHECK(DescribeParameter(alphabet[plasticoding::kMoveRefI].parameters[0]) ==
        "`t` in 1 or more, a whole number: edge to the temporary node, counted "
        "from 1");
}

TEST_CASE("States and environments are described", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const auto& states = analysis.sections()[0].scope.header.states;
  CHECK(DescribeState(states[0]) == "```pls\nsense inclined: bool\n```\n");
  CHECK(DescribeState(states[1]) ==
        "```pls\nsense warmth: real in -40..60\n```\n");
  CHECK(DescribeState(states[2]) ==
        "```pls\nsense ground: { dry, wet }\n```\n");
  CHECK(DescribeEnvironment({"e", {{1, 2, 0}}}, states) ==
        "```pls\nenvironment e\n```\ninclined=True,warmth=2,ground=dry\n");
}

TEST_CASE("A clause's truth table has a row for each environment", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const Program& program = analysis.compiled()->front().program;
  CHECK(TruthMarkdown(program.genotype.rules[1].clause,
                      program.genotype.states) ==
        "| inclined | warmth | ground | active |\n|---|---|---|---|\n"
        "| False | -40..12.5 | dry | no |\n"
        "| False | -40..12.5 | wet | no |\n"
        "| False | >12.5..60 | dry | **yes** |\n"
        "| False | >12.5..60 | wet | no |\n"
        "| True | -40..12.5 | dry | **yes** |\n"
        "| True | -40..12.5 | wet | **yes** |\n"
        "| True | >12.5..60 | dry | **yes** |\n"
        "| True | >12.5..60 | wet | **yes** |\n"
        "\nActive in 5 of 8 environments.\n");
}

TEST_CASE("Long truth tables are cut", "[lsp]") {
  std::vector<State> states(17);
  Clause clause;
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].name = "s" + std::to_string(i);
    clause.terms.push_back({static_cast<StateId>(i), Comparison::kEqual, 1});
    if (i > 0) clause.connectives.push_back(Connective::kOr);
  }
  CHECK(TruthMarkdown(clause, states) ==
        "The clause tells apart more than 65536 environments.\n");
  clause.terms.resize(6);
  clause.connectives.resize(5);
  const std::string text = TruthMarkdown(clause, states);
  CHECK(std::count(text.begin(), text.end(), '\n') == kMaxTruthRows + 6);
  CHECK(text.find("... and 32 environments more") != std::string::npos);
}

}  // namespace plsc::lsp
