#pragma once

// What a reader of a report must know before its figures: in which keys its
// experiments differ from each other, and from the paper's.

#include <optional>
#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"

namespace plsc {

struct KeyDifference {
  std::string key;                   ///< "scenario.seasons.flat.duration"
  std::optional<std::string> paper;  ///< nothing: the paper's has no such key
  /// By experiment, likewise.
  std::vector<std::optional<std::string>> values;
  bool is_between = false;  ///< whether two of the experiments differ in it
};

/// Keys in which an experiment differs from another or from the paper, in the
/// order of docs/experiments.md. Names and seeds are no difference.
std::vector<KeyDifference> DifferencesOf(
    const std::vector<Experiment>& experiments);

}  // namespace plsc
