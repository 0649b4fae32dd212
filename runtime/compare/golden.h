#pragma once

// What a golden test remembers of a genotype in one environment, as facts that
// a person can read and that do not depend on memory layout: the string, every
// module, node and edge, the descriptors. Observe makes them from a genotype;
// runtime/compare/golden_json reads and writes them, golden_compare says how
// two differ. Knows no files.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/program.h"

namespace plsc {

/// Symbols of a string that are written out, one a line. A robot of 15 modules
/// rarely takes more, and nobody reads longer lists; of what follows only the
/// number and a hash are kept.
inline constexpr std::size_t kGoldenSymbols = 500;

struct GoldenString {
  std::vector<std::string> symbols;  ///< "A1(0.5, 1.0, 2.0, 3.0)", the first
  std::size_t length = 0;            ///< of the whole string
  std::string hash;  ///< of the whole, when longer than kGoldenSymbols

  friend bool operator==(const GoldenString&, const GoldenString&) = default;
};

struct GoldenCell {
  int x = 0;  ///< + to the core's right
  int y = 0;  ///< + to the core's front

  friend bool operator==(const GoldenCell&, const GoldenCell&) = default;
};

struct GoldenModule {
  std::string id;                  ///< "7", of a sensor "7s1"
  std::string type;                ///< "C", "B", "A1", "A2", "T"
  std::string parent;              ///< id; empty for the core
  std::string slot;                ///< of the parent; empty for the core
  std::optional<GoldenCell> cell;  ///< none for sensors
  std::string facing;              ///< empty for sensors
  int angle_deg = 0;               ///< roll relative to the parent

  friend bool operator==(const GoldenModule&, const GoldenModule&) = default;
};

struct GoldenNode {
  std::string id;      ///< "node3"
  std::string module;  ///< id
  bool is_oscillator = false;
  double weight = 0;
  double amplitude = 0;     ///< oscillators only, as the next two
  double period = 0;        ///< s
  double phase_offset = 0;  ///< in periods

  friend bool operator==(const GoldenNode&, const GoldenNode&) = default;
};

struct GoldenEdge {
  std::string source;       ///< id of a node
  std::string destination;  ///< id of a node
  double weight = 0;

  friend bool operator==(const GoldenEdge&, const GoldenEdge&) = default;
};

using GoldenValues = std::vector<std::pair<std::string, double>>;

struct GoldenRobot {
  std::vector<GoldenModule> modules;
  std::vector<GoldenNode> nodes;
  std::vector<GoldenEdge> edges;
  GoldenValues body_descriptors;
  GoldenValues brain_descriptors;

  friend bool operator==(const GoldenRobot&, const GoldenRobot&) = default;
};

struct Observation {
  /// "inclined=True": what a named environment means; empty where the
  /// environment is written as such an assignment itself.
  std::string senses;
  std::vector<int> active_rules;  ///< numbers from 1, in file order
  GoldenString string;
  std::optional<GoldenRobot> robot;  ///< of alphabets that have bodies

  friend bool operator==(const Observation&, const Observation&) = default;
};

/// One environment of a golden file.
struct GoldenCase {
  std::string environment;  ///< a name of the genotype's file, or "a=True,b=1"
  /// None: somebody wrote the environment and left the rest to --update.
  std::optional<Observation> expected;
  std::string genotype{};  ///< of a file of several; else empty

  friend bool operator==(const GoldenCase&, const GoldenCase&) = default;
};

struct Golden {
  /// Of descriptors only, relative to the expected value (absolute below 1).
  /// They use exp and sqrt, whose last digits differ between C libraries;
  /// 1e-9 is far above that and far below any change of a body or brain.
  double descriptor_tolerance = 1e-9;
  std::vector<GoldenCase> cases;

  friend bool operator==(const Golden&, const Golden&) = default;
};

/// Nothing when the string would grow beyond kMaxStringLength.
std::optional<Observation> Observe(const Genotype& genotype,
                                   const NamedEnvironment& environment);

/// The environments of a golden file that is made from nothing: those that the
/// file names; "any" when nothing is sensed; else every combination of bool
/// and enum states, if at most kMaxGoldenCombinations. Empty when a person
/// has to choose.
std::vector<std::string> DefaultEnvironments(const Program& program);

/// Four bool states: more bodies of one genotype nobody looks through.
inline constexpr std::size_t kMaxGoldenCombinations = 16;

}  // namespace plsc
