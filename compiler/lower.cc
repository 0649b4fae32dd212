// From the tree to the IR. Nothing can be wrong here any more, so everything is
// taken with value() and at(): an empty one is a mistake of ours and ends the
// process rather than become a robot.
//
// Rules are sorted stably by head. Evolution and Print want the rules of a
// symbol together; among them the order of the file is the order in which
// active ones are joined, and must stay. MapSource asks for the same order
// (RuleOrder), so that rule i of the map is rule i of the genotype.

#include "compiler/lower.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string_view>
#include <unordered_map>

namespace plsc {

namespace {

std::vector<Symbol> LowerSymbols(const ast::File& file, ast::Range symbols,
                                 const Resolution& resolution) {
  std::vector<Symbol> production(symbols.count);
  for (std::uint32_t k = 0; k < symbols.count; ++k) {
    const std::uint32_t at = symbols.first + k;
    const ast::Range arguments = file.symbols[at].arguments;
    production[k].id = resolution.symbols[at].value();
    assert(arguments.count <= kMaxParameters);
    for (std::uint32_t a = 0; a < arguments.count; ++a)
      production[k].arguments[a] =
          resolution.arguments[arguments.first + a].value;
  }
  return production;
}

NamedEnvironment LowerEnvironment(const ast::File& file, const Scope& scope,
                                  const Resolution& resolution,
                                  const ast::Environment& declared) {
  NamedEnvironment environment;
  environment.name = file.Text(declared.name);
  environment.environment.values.resize(scope.header.states.size());
  for (std::uint32_t k = 0; k < declared.entries.count; ++k) {
    const Term entry = resolution.entries[declared.entries.first + k].value();
    environment.environment.values[static_cast<std::size_t>(entry.state)] =
        entry.value;
  }
  return environment;
}

std::vector<ExpectedSymbol> LowerExpectedString(const ast::File& file,
                                                const Scope& scope,
                                                const ast::Test& test,
                                                const Resolution& resolution) {
  std::vector<ExpectedSymbol> expected;
  expected.reserve(test.symbols.count);
  for (Symbol& symbol : LowerSymbols(file, test.symbols, resolution)) {
    const auto at =
        test.symbols.first + static_cast<std::uint32_t>(expected.size());
    const bool takes_any = !file.symbols[at].has_parens &&
                           !scope.header.SymbolOf(symbol.id).parameters.empty();
    expected.push_back({symbol, !takes_any});
  }
  return expected;
}

std::vector<ExpectedModule> LowerExpectedBody(const ast::File& file,
                                              const ast::Test& test,
                                              const Resolution& resolution) {
  std::vector<ExpectedModule> expected;
  expected.reserve(test.nodes.count);
  for (std::uint32_t k = 0; k < test.nodes.count; ++k) {
    const ResolvedNode& node = resolution.nodes[test.nodes.first + k];
    const auto depth = static_cast<int>(file.nodes[test.nodes.first + k].depth);
    expected.push_back({node.symbol.value(), depth,
                        depth > 0 ? node.face.value() : Face::kFront});
  }
  return expected;
}

using PlacesByName = std::unordered_map<std::string_view, const Environment*>;

InlineTest LowerTest(const ast::File& file, const Scope& scope,
                     const ast::Test& test, const Resolution& resolution,
                     const PlacesByName& places) {
  InlineTest lowered;
  lowered.name = file.Text(test.name);
  if (test.environment.end > 0) {
    lowered.place = file.Text(test.environment);
    lowered.environment = *places.at(lowered.place);
  }
  if (test.has_after) lowered.after = static_cast<int>(test.after.number);
  lowered.string = LowerExpectedString(file, scope, test, resolution);
  lowered.body = LowerExpectedBody(file, test, resolution);
  return lowered;
}

}  // namespace

Clause LowerClause(const ast::File& file, const ast::Rule& rule,
                   const Resolution& resolution) {
  Clause clause;
  clause.terms.reserve(rule.terms.count);
  clause.connectives.reserve(rule.terms.count);
  for (std::uint32_t k = 0; k < rule.terms.count; ++k) {
    const std::uint32_t at = rule.terms.first + k;
    clause.terms.push_back(resolution.terms[at].value());
    if (k > 0)
      clause.connectives.push_back(
          file.terms[at].connective == ast::Connective::kAnd ? Connective::kAnd
                                                             : Connective::kOr);
  }
  return clause;
}

std::vector<std::size_t> RuleOrder(const Resolution& resolution) {
  std::vector<std::size_t> order(resolution.heads.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) {
                     return resolution.heads[a] < resolution.heads[b];
                   });
  return order;
}

Program Lower(const ast::File& file, const Scope& scope,
              const Resolution& resolution) {
  Program program;
  program.genotype = scope.header;
  program.genotype.rules.reserve(file.rules.size());
  for (const std::size_t index : RuleOrder(resolution)) {
    const ast::Rule& rule = file.rules[index];
    program.genotype.rules.push_back(
        {resolution.heads[index].value(), LowerClause(file, rule, resolution),
         LowerSymbols(file, rule.symbols, resolution)});
  }
  for (const ast::Environment& environment : file.environments)
    program.environments.push_back(
        LowerEnvironment(file, scope, resolution, environment));
  if (file.tests.empty()) return program;
  PlacesByName places;
  for (const NamedEnvironment& named : program.environments)
    places.emplace(named.name, &named.environment);
  for (const ast::Test& test : file.tests)
    program.tests.push_back(LowerTest(file, scope, test, resolution, places));
  return program;
}

}  // namespace plsc
