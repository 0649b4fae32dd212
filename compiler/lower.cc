#include "compiler/lower.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace plsc {

namespace {

std::vector<Symbol> LowerProduction(const ast::File& file,
                                    const ast::Rule& rule,
                                    const Resolution& resolution) {
  std::vector<Symbol> production(rule.symbols.count);
  for (std::uint32_t k = 0; k < rule.symbols.count; ++k) {
    const std::uint32_t at = rule.symbols.first + k;
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
    program.genotype.rules.push_back({resolution.heads[index].value(),
                                      LowerClause(file, rule, resolution),
                                      LowerProduction(file, rule, resolution)});
  }
  for (const ast::Environment& environment : file.environments)
    program.environments.push_back(
        LowerEnvironment(file, scope, resolution, environment));
  return program;
}

}  // namespace plsc
