#pragma once

// A first genotype, drawn at random (paper, "Initialization"). The next ones
// come of crossover and mutation.

#include <optional>
#include <vector>

#include "compiler/genotype.h"
#include "runtime/vary/rng.h"

namespace plsc {

enum class Encoding : std::uint8_t {
  kPlasticoding,  ///< several rules a symbol, each with a clause
  kBaseline,      ///< one rule a symbol, always active
};

/// What first genotypes are made of, and what their descendants keep to.
/// Defaults are the paper's (Table 2 and "Experimental setup").
struct GenotypeOptions {
  Encoding encoding = Encoding::kPlasticoding;
  DevelopmentSettings development;
  /// What clauses ask about; not empty for kPlasticoding, unused otherwise.
  std::vector<State> states = {{"inclined", StateType::kBool, 0, 0, {}}};
  int min_groups = 1;  ///< groups of five symbols a rule, 1 to max_groups
  int max_groups = 4;  ///< e
  /// The number of groups is drawn for each rule, not once a genotype. The
  /// paper can be read either way; the authors' program draws once.
  bool groups_per_rule = false;
  int max_rules = 2;  ///< l, rules a symbol, all used; kPlasticoding only
  int max_terms = 2;  ///< u, terms a clause; kPlasticoding only
  /// Terms of a first clause: 0 to max_terms. A clause of none always holds.
  int min_initial_terms = 1;
  /// min_initial_terms to max_terms; absent: max_terms.
  std::optional<int> max_initial_terms;

  friend bool operator==(const GenotypeOptions&,
                         const GenotypeOptions&) = default;
};

/// Rules for every replaceable symbol. A rule is of min_groups to max_groups
/// groups, as likely each, of one symbol each of: controller-moving,
/// controller-changing, mounting, module (not C), moving; rules of C have C in
/// front. Without a name.
Genotype Initialise(const GenotypeOptions& options, Rng& rng);

}  // namespace plsc
