// From tables, not from the robots in a run's memory, so that one way of
// counting serves the run that goes on, the one that was resumed, and older
// stores, whose reports count what their runs did not.
//
// Rules are stored once a text and headers likewise, so two genotypes are the
// same if these numbers are; two robots if the keys of their phenotypes are.
// Founders are sets of bits that children take from their parents, and that are
// forgotten with who dies: a generation costs as many unions as it has newborn
// survivors. Clauses repeat even more than rules do, so each text is compiled
// once, and what is sensed is parsed once.
//
// A run of 20,000 robots is counted in a twentieth of a second: a fraction of a
// millisecond a generation.

#include "runtime/store/census.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <set>
#include <string_view>
#include <utility>

#include "compiler/compile.h"
#include "compiler/environment_text.h"
#include "compiler/print.h"
#include "compiler/truth.h"
#include "runtime/life/season_developer.h"
#include "runtime/store/names.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

/// "inclined = True" of "rule C -> if inclined = True then {..."; empty if the
/// rule has no clause. As Print writes it.
std::string_view ClauseText(std::string_view rule) {
  constexpr std::string_view kIf = " -> if ", kThen = " then {\n";
  const std::size_t line = rule.find('\n');
  const std::size_t begin = rule.find(kIf);
  const std::size_t end = rule.find(kThen);
  if (line == std::string_view::npos || begin >= line || end >= line) return {};
  return rule.substr(begin + kIf.size(), end - begin - kIf.size());
}

/// Nothing if it is none, as in a damaged store.
std::optional<Clause> ParseClause(std::string_view text,
                                  const std::vector<State>& states) {
  Genotype bare;
  bare.name = "bare";
  bare.states = states;
  bare.axiom = plasticoding::kC;
  bare.rules = {{plasticoding::kC, {}, {{plasticoding::kC, {}}}}};
  std::string program = Print(bare);
  constexpr std::string_view kArrow = " -> ";
  program.insert(program.rfind(kArrow) + kArrow.size(),
                 fmt::format("if {} then ", text));
  CompileOptions options;
  options.allow_out_of_range = true;
  Result<Program> compiled = Compile(Source("clause", program), options);
  if (!compiled || compiled->genotype.rules.size() != 1) return std::nullopt;
  return std::move(compiled->genotype.rules.front().clause);
}

/// Nothing if it is not of these states, as where no season was lived.
std::optional<Environment> ParseEnvironment(const std::string& sensed,
                                            const std::vector<State>& states) {
  const auto senses = SensesOf(sensed);
  if (!senses || senses->size() != states.size()) return std::nullopt;
  Environment environment;
  for (const State& state : states) {
    const auto found = senses->find(state.name);
    if (found == senses->end()) return std::nullopt;
    const auto value = ParseStateValue(found->second, state);
    if (!value) return std::nullopt;
    environment.values.push_back(*value);
  }
  return environment;
}

std::vector<CensusCounts> Kept(Database& database) {
  std::vector<CensusCounts> all;
  Statement row(database,
                fmt::format("SELECT {} FROM generation ORDER BY number",
                            fmt::join(CensusColumns(), ", ")));
  for (row.With(); row.Next();) {
    CensusCounts counts;
    for (std::int64_t* one :
         {&counts.genotypes, &counts.phenotypes, &counts.founders,
          &counts.plastic_bodies, &counts.plastic_brains, &counts.rules,
          &counts.regulated_rules, &counts.silent_rules})
      *one = row.TakeInteger();
    all.push_back(counts);
  }
  return all;
}

}  // namespace

std::array<std::int64_t, 8> List(const CensusCounts& counts) {
  return {counts.genotypes,       counts.phenotypes,     counts.founders,
          counts.plastic_bodies,  counts.plastic_brains, counts.rules,
          counts.regulated_rules, counts.silent_rules};
}

Census::Census(Database& database, const Experiment& experiment,
               std::size_t most_rules)
    : most_rules_(most_rules),
      states_(experiment.genotype.states),
      words_((static_cast<std::size_t>(experiment.population) + 63) / 64),
      parents_(database,
               "SELECT parent1, parent2, from_second FROM individual "
               "WHERE id = ?"),
      rules_(database,
             "SELECT rule, header FROM genotype_rule "
             "JOIN individual ON individual.id = genotype_rule.individual "
             "WHERE individual = ? ORDER BY position"),
      seasons_(database,
               "SELECT phenotype, body, sensed FROM evaluation "
               "LEFT JOIN phenotype ON phenotype.key = evaluation.phenotype "
               "WHERE individual = ? ORDER BY season"),
      rule_(database, "SELECT text FROM rule WHERE id = ?"),
      clauses_(1) {}

CensusCounts Census::Count(const std::vector<int>& survivors) {
  Pass(survivors);
  if (clause_of_.size() > most_rules_) {
    clause_of_.clear();
    clause_places_.clear();
    clauses_.resize(1);
  }
  CensusCounts counts;
  std::set<std::vector<std::int64_t>> genotypes;
  std::set<std::string> phenotypes;
  Bits founders(words_);
  for (const int id : survivors) {
    Robot& robot = robots_[id];
    if (!robot.is_read) Read(id, robot);
    genotypes.insert(robot.genotype);
    phenotypes.insert(robot.phenotypes);
    for (std::size_t i = 0; i < words_; ++i) founders[i] |= robot.founders[i];
    if (robot.has_plastic_body) ++counts.plastic_bodies;
    if (robot.has_plastic_brain) ++counts.plastic_brains;
    counts.rules += static_cast<std::int64_t>(robot.genotype.size()) - 1;
    counts.regulated_rules += robot.regulated;
    counts.silent_rules += robot.silent;
  }
  counts.genotypes = static_cast<std::int64_t>(genotypes.size());
  counts.phenotypes = static_cast<std::int64_t>(phenotypes.size());
  for (const std::uint64_t word : founders)
    counts.founders += std::popcount(word);
  return counts;
}

void Census::Pass(const std::vector<int>& survivors) {
  std::unordered_map<int, Robot> next;
  for (const int id : survivors) {
    const auto known = robots_.find(id);
    if (known != robots_.end())
      next[id] = known->second;
    else
      next[id].founders = FoundersOf(id);
  }
  robots_ = std::move(next);
  ++generation_;
}

Census::Bits Census::FoundersOf(int id) {
  Bits founders(words_);
  if (generation_ == 0) {
    const auto bit = static_cast<std::size_t>(id - 1);
    if (bit / 64 < words_) founders[bit / 64] |= std::uint64_t{1} << bit % 64;
    return founders;
  }
  if (!parents_.With(id).Next()) return founders;
  const int first = parents_.TakeInt();
  const int second = parents_.TakeInt();
  const bool has_of_second = parents_.TakeText() != "[]";
  parents_.Run();
  for (const int parent : {first, has_of_second ? second : first}) {
    const auto found = robots_.find(parent);
    if (found == robots_.end()) continue;
    for (std::size_t i = 0; i < words_; ++i)
      founders[i] |= found->second.founders[i];
  }
  return founders;
}

void Census::Read(int id, Robot& robot) {
  robot.is_read = true;
  const std::vector<std::size_t> environments = ReadSeasons(id, robot);
  robot.genotype = {0};
  for (rules_.With(id); rules_.Next();) {
    robot.genotype.push_back(rules_.TakeInteger());
    robot.genotype.front() = rules_.TakeInteger();
  }
  for (std::size_t i = 1; i < robot.genotype.size(); ++i) {
    const std::size_t clause = ClauseOf(robot.genotype[i]);
    if (clause == 0) continue;
    ++robot.regulated;
    if (std::none_of(environments.begin(), environments.end(),
                     [&](std::size_t one) { return Holds(clause, one); }))
      ++robot.silent;
  }
}

std::vector<std::size_t> Census::ReadSeasons(int id, Robot& robot) {
  std::vector<std::size_t> environments;
  std::string first_body, first_robot;
  bool is_first = true;
  for (seasons_.With(id); seasons_.Next();) {
    const std::string key = seasons_.TakeText();
    const std::string body = seasons_.TakeText();
    const std::string sensed = seasons_.TakeText();
    if (is_first) {
      first_robot = key;
      first_body = body;
    } else if (body != first_body) {
      robot.has_plastic_body = true;
    } else if (key != first_robot) {
      robot.has_plastic_brain = true;
    }
    robot.phenotypes += key + ' ';
    const auto [place, is_new] =
        environment_places_.emplace(sensed, environments_.size());
    if (is_new) environments_.push_back(ParseEnvironment(sensed, states_));
    environments.push_back(place->second);
    is_first = false;
  }
  if (robot.has_plastic_body) robot.has_plastic_brain = false;
  return environments;
}

std::size_t Census::ClauseOf(std::int64_t rule) {
  const auto known = clause_of_.find(rule);
  if (known != clause_of_.end()) return known->second;
  std::string text;
  if (rule_.With(rule).Next()) text = rule_.TakeText();
  rule_.Run();
  const std::string clause(ClauseText(text));
  std::size_t number = 0;
  if (!clause.empty()) {
    const auto [place, is_new] =
        clause_places_.emplace(clause, clauses_.size());
    if (is_new)
      clauses_.push_back(ParseClause(clause, states_).value_or(Clause{}));
    number = place->second;
  }
  clause_of_.emplace(rule, number);
  return number;
}

bool Census::Holds(std::size_t clause, std::size_t environment) {
  const std::optional<Environment>& sensed = environments_[environment];
  return sensed && ClauseHolds(clauses_[clause], sensed->values);
}

std::vector<CensusCounts> CensusOf(Database& database,
                                   const Experiment& experiment) {
  if (SchemaOf(database) >= 3) return Kept(database);
  std::vector<std::vector<int>> survivors(static_cast<std::size_t>(
      SingleInteger(database, "SELECT count(*) FROM generation")));
  Statement row(database,
                "SELECT generation, individual FROM member "
                "WHERE survivor IS NOT NULL ORDER BY generation, individual");
  for (row.With(); row.Next();) {
    const auto generation = static_cast<std::size_t>(row.TakeInteger());
    if (generation < survivors.size())
      survivors[generation].push_back(row.TakeInt());
  }
  Census census(database, experiment);
  std::vector<CensusCounts> all;
  all.reserve(survivors.size());
  for (const std::vector<int>& of : survivors) all.push_back(census.Count(of));
  return all;
}

}  // namespace plsc
