#include "runtime/advice/stats_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "compiler/print.h"
#include "runtime/text/aligned_rows.h"
#include "runtime/text/json_dump.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

// The first cell is the row's title.
using Row = std::vector<std::string>;

std::string Share(std::size_t part, std::size_t whole) {
  if (whole == 0) return "0";
  const double percent =
      100 * static_cast<double>(part) / static_cast<double>(whole);
  return fmt::format("{} ({:.0f} %)", part, percent);
}

Row RowOf(std::string title, const GenotypeStats& stats,
          const std::function<std::string(const EnvironmentStats&)>& cell) {
  Row row = {std::move(title)};
  for (const EnvironmentStats& one : stats.environments)
    row.push_back(cell(one));
  return row;
}

std::string DifferenceText(const RobotDifference& difference) {
  return fmt::format("{} shared, {} other, {} new, {} gone", difference.shared,
                     difference.other, difference.added, difference.missing);
}

std::string RuleTitle(const Genotype& genotype, std::size_t rule) {
  const Rule& one = genotype.rules[rule];
  const std::string clause =
      one.clause.is_always() ? "" : " if " + PrintClause(one.clause, genotype);
  return fmt::format("rule {}: {}{}", rule + 1,
                     genotype.SymbolOf(one.head).name, clause);
}

std::string UsageText(const RuleUsage& usage, std::size_t symbols,
                      bool has_body) {
  if (!usage.is_active) return "-";
  std::string text = fmt::format("{}x, {} of {} symbols", usage.applied,
                                 usage.expressed, symbols);
  if (has_body) text += fmt::format(", {} modules", usage.modules);
  return text;
}

std::vector<Row> RobotRows(const GenotypeStats& stats) {
  using One = const EnvironmentStats&;
  std::vector<Row> rows = {
      RowOf("modules", stats, [](One e) { return std::to_string(e.modules); }),
      RowOf("  joints", stats, [](One e) { return std::to_string(e.joints); }),
      RowOf("sensors", stats, [](One e) { return std::to_string(e.sensors); }),
      RowOf("brain nodes", stats,
            [](One e) { return std::to_string(e.nodes); }),
      RowOf("brain edges", stats,
            [](One e) { return std::to_string(e.edges); })};
  if (stats.environments.size() < 2) return rows;
  const EnvironmentStats* first = &stats.environments.front();
  rows.push_back(RowOf("body", stats, [&](One e) {
    return &e == first ? "reference" : DifferenceText(e.difference);
  }));
  rows.push_back(RowOf("brain", stats, [&](One e) {
    if (&e == first) return "reference";
    return e.difference.other_brain ? "another" : "the same";
  }));
  return rows;
}

std::vector<Row> EnvironmentRows(const Genotype& genotype,
                                 const GenotypeStats& stats) {
  using One = const EnvironmentStats&;
  std::vector<Row> rows = {
      RowOf("", stats, [](One e) { return e.name; }),
      RowOf("active rules", stats,
            [&](One e) {
              const auto active = std::count_if(
                  e.rules.begin(), e.rules.end(),
                  [](const RuleUsage& usage) { return usage.is_active; });
              return Share(static_cast<std::size_t>(active), stats.rules);
            }),
      RowOf("expressed symbols", stats,
            [&](One e) { return Share(e.expressed, stats.symbols); }),
      RowOf("derived string", stats,
            [](One e) { return std::to_string(e.length); }),
      RowOf("  of it expressed", stats,
            [](One e) { return Share(e.string_expressed, e.length); })};
  const bool has_body =
      !stats.environments.empty() && stats.environments.front().has_body;
  if (has_body)
    for (Row& row : RobotRows(stats)) rows.push_back(std::move(row));
  for (std::size_t rule = 0; rule < stats.rules; ++rule)
    rows.push_back(RowOf(RuleTitle(genotype, rule), stats, [&](One e) {
      return UsageText(e.rules[rule], genotype.rules[rule].production.size(),
                       has_body);
    }));
  return rows;
}

Json UsageJson(const RuleUsage& usage) {
  return {{"active", usage.is_active},
          {"applied", usage.applied},
          {"expressed", usage.expressed},
          {"modules", usage.modules}};
}

Json EnvironmentJson(const EnvironmentStats& one) {
  Json rules = Json::array();
  for (const RuleUsage& usage : one.rules) rules.push_back(UsageJson(usage));
  Json json = {{"environment", one.name},
               {"string", one.length},
               {"string_expressed", one.string_expressed},
               {"expressed", one.expressed},
               {"rules", std::move(rules)}};
  if (!one.has_body) return json;
  json["modules"] = one.modules;
  json["joints"] = one.joints;
  json["sensors"] = one.sensors;
  json["nodes"] = one.nodes;
  json["edges"] = one.edges;
  json["difference"] = {{"shared", one.difference.shared},
                        {"other", one.difference.other},
                        {"new", one.difference.added},
                        {"missing", one.difference.missing},
                        {"brain", one.difference.other_brain}};
  return json;
}

Json RulesJson(const Genotype& genotype) {
  Json rules = Json::array();
  for (const Rule& rule : genotype.rules)
    rules.push_back({{"symbol", genotype.SymbolOf(rule.head).name},
                     {"clause", PrintClause(rule.clause, genotype)},
                     {"symbols", rule.production.size()}});
  return rules;
}

}  // namespace

std::string StatsText(const Genotype& genotype, const GenotypeStats& stats) {
  std::string text = fmt::format(
      "{}: {} rules, {} terms of clauses, {} symbols\n"
      "in some environment: {} rules active, {} symbols expressed\n",
      stats.name, stats.rules, stats.terms, stats.symbols,
      Share(stats.active, stats.rules), Share(stats.expressed, stats.symbols));
  if (stats.bodies > 0 && stats.environments.size() > 1)
    text += fmt::format("over {} environments: {} {}, {} {}\n",
                        stats.environments.size(), stats.bodies,
                        stats.bodies == 1 ? "body" : "bodies", stats.brains,
                        stats.brains == 1 ? "brain" : "brains");
  return text + '\n' + AlignedRows(EnvironmentRows(genotype, stats));
}

std::string StatsJson(const std::string& path, const Genotype& genotype,
                      const GenotypeStats& stats) {
  Json environments = Json::array();
  for (const EnvironmentStats& one : stats.environments)
    environments.push_back(EnvironmentJson(one));
  const Json json = {{"file", path},
                     {"genotype", stats.name},
                     {"rules", RulesJson(genotype)},
                     {"terms", stats.terms},
                     {"symbols", stats.symbols},
                     {"active", stats.active},
                     {"expressed", stats.expressed},
                     {"bodies", stats.bodies},
                     {"brains", stats.brains},
                     {"environments", std::move(environments)}};
  return DumpJson(json);
}

}  // namespace plsc
