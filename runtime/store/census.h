#pragma once

// A generation's survivors, counted: how many are alike, of how many founders
// they descend, how plastic they are. Kept with each generation, since schema 3
// of a store; of older ones it is counted from the same tables.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/store/database.h"

namespace plsc {

struct CensusCounts {
  std::int64_t genotypes = 0;   ///< distinct ones; their names apart
  std::int64_t phenotypes = 0;  ///< distinct, as the robots of all seasons
  /// Robots of generation 0 that they descend from: by their first parents, and
  /// by second ones that gave them rules.
  std::int64_t founders = 0;
  /// Survivors that are not the same robot in all seasons: by their body, or by
  /// their brain alone. No robot is another one than any.
  std::int64_t plastic_bodies = 0;
  std::int64_t plastic_brains = 0;
  /// Rules of all survivors together; those with a clause; those of them whose
  /// clause held in no season.
  std::int64_t rules = 0;
  std::int64_t regulated_rules = 0;
  std::int64_t silent_rules = 0;

  friend bool operator==(const CensusCounts&, const CensusCounts&) = default;
};

/// In the order of CensusColumns (schema.h).
std::array<std::int64_t, 8> List(const CensusCounts& counts);

/// Counts generation after generation, from the first one. The tables must have
/// the births and evaluations of who is counted.
class Census {
 public:
  /// Forgets clauses when it knows those of more rules than `most_rules`, twice
  /// what a population of the paper has: most rules of a long run are gone.
  Census(Database& database, const Experiment& experiment,
         std::size_t most_rules = 2000);

  /// Of the next generation: its survivors, by id. Each must have survived the
  /// one before, or be a child of who did.
  CensusCounts Count(const std::vector<int>& survivors);
  /// The same, where only what later generations descend from is asked for.
  void Pass(const std::vector<int>& survivors);

 private:
  using Bits = std::vector<std::uint64_t>;
  /// What is known of a survivor.
  struct Robot {
    Bits founders;  ///< by id - 1
    bool is_read = false;
    std::vector<std::int64_t> genotype;  ///< header, rules: by number
    std::string phenotypes;              ///< keys, of all seasons
    bool has_plastic_body = false;
    bool has_plastic_brain = false;
    int regulated = 0;
    int silent = 0;
  };

  Bits FoundersOf(int id);
  void Read(int id, Robot& robot);
  /// What it senses that regulates it, as numbers in environments_.
  std::vector<std::size_t> ReadSeasons(int id, Robot& robot);
  /// Of a rule: its clause, a number in clauses_; 0 is none.
  std::size_t ClauseOf(std::int64_t rule);
  bool Holds(std::size_t clause, std::size_t environment);

  std::size_t most_rules_;
  std::vector<State> states_;
  std::size_t words_;  ///< of a founder set
  Statement parents_;
  Statement rules_;
  Statement seasons_;
  Statement rule_;
  std::unordered_map<int, Robot> robots_;  ///< of the latest generation
  int generation_ = 0;                     ///< the next
  std::unordered_map<std::int64_t, std::size_t> clause_of_;     ///< by rule
  std::unordered_map<std::string, std::size_t> clause_places_;  ///< by text
  std::vector<Clause> clauses_;
  std::unordered_map<std::string, std::size_t> environment_places_;  ///< JSON
  std::vector<std::optional<Environment>> environments_;
};

/// Of all completed generations: as they are kept, or counted where the store
/// has none. What cannot be read is a failure of the database.
std::vector<CensusCounts> CensusOf(Database& database,
                                   const Experiment& experiment);

}  // namespace plsc
