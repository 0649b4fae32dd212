#pragma once

// How much of a genotype is used: symbols expressed, rules applied, modules by
// rule, and how the robots of several environments differ. Counts only; what a
// single symbol did is runtime/develop/trace's to tell.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/program.h"
#include "grammar/expected.h"

namespace plsc {

/// A rule in one environment.
struct RuleUsage {
  bool is_active = false;
  std::uint64_t applied = 0;  ///< symbols that it (or it and others) replaced
  std::size_t expressed = 0;  ///< of its symbols, those expressed here
  std::size_t modules = 0;    ///< sensors too, that its symbols mounted
};

/// Against the robot of the first environment
/// (runtime/compare/body_difference.h).
struct RobotDifference {
  std::size_t shared = 0;   ///< modules at the same place, of the same kind
  std::size_t other = 0;    ///< of another kind or roll
  std::size_t added = 0;    ///< where the first has none
  std::size_t missing = 0;  ///< of the first, where here is none
  bool other_brain = false;
};

/// Of an alphabet without bodies a symbol is expressed where it stands in the
/// final string, or was rewritten before.
struct EnvironmentStats {
  std::string name;
  std::vector<RuleUsage> rules;      ///< of Genotype::rules
  std::size_t length = 0;            ///< of the derived string
  std::size_t string_expressed = 0;  ///< of it, symbols that did something
  std::size_t expressed = 0;  ///< written symbols that did, or were rewritten
  bool has_body = false;      ///< all below is 0 without
  std::size_t modules = 0;    ///< the core, without sensors
  std::size_t joints = 0;
  std::size_t sensors = 0;
  std::size_t nodes = 0;
  std::size_t edges = 0;
  RobotDifference difference;
};

struct GenotypeStats {
  std::string name;
  std::size_t rules = 0;
  std::size_t terms = 0;
  std::size_t symbols = 0;
  std::size_t expressed = 0;  ///< symbols, in some environment
  std::size_t active = 0;     ///< rules, in some environment
  std::vector<EnvironmentStats> environments;
  /// Different ones over the environments; 1 is not plastic. As in reports a
  /// brain is its nodes, by the ids of their modules, and its edges.
  std::size_t bodies = 0;
  std::size_t brains = 0;
};

/// The environment (an index) in which the string, or its history, outgrows its
/// limit.
struct OutgrownIn {
  std::size_t environment = 0;
};
Expected<GenotypeStats, OutgrownIn> StatsOf(
    const Genotype& genotype,
    const std::vector<NamedEnvironment>& environments);

}  // namespace plsc
