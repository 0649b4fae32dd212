#pragma once

// Late development with its history: for each symbol of the string what it did
// or why it was not expressed, and for each module, node and edge the symbol
// that made it. The phenotype is Develop's, as both use one StringReader.

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/develop/derivation.h"
#include "runtime/develop/string_reader.h"

namespace plsc {

/// Index into the final string.
using StringIndex = std::uint32_t;
inline constexpr StringIndex kNoIndex = 0xFFFFFFFF;

/// One symbol of the string, read. What a field means, and whether it is
/// filled, is the effect's to say.
struct Event {
  Effect effect = Effect::kStarted;
  int reference = 0;  ///< the module-reference before, index into modules
  /// kMounted: the new one; kModuleReached: where the reference now is;
  /// kSlotTaken, kCellTaken, kSensorThere: the one in the way.
  int module = kNoModule;
  /// Of modules the slot that was tried on `reference`, of mounting commands
  /// their side, of move_front, move_left and move_right the slot looked at.
  std::optional<Slot> slot;
  /// kNodeReached: where the reference was and is. kNeuronChanged: `node`.
  /// Modules that brought a node: `node`.
  int node_before = kNoNode;
  int node = kNoNode;
  /// The edges that it made, by index; kEdgeChanged, kEdgeExists, kLoopExists:
  /// the one concerned.
  int edge = kNoEdge;
  int edge_count = 0;
  double before = 0;  ///< kEdgeChanged, kNeuronChanged: the value
  double after = 0;
  /// Modules: the last mounting command before them. kSlotUsed: the module
  /// that used it. kSlotOverwritten: the command that overwrote it.
  StringIndex partner = kNoIndex;
};

struct Trace {
  Phenotype phenotype;
  std::vector<Event> events;  ///< one a symbol of the string
  // By module, node and edge: the symbol that made it.
  std::vector<StringIndex> module_origins;
  std::vector<StringIndex> node_origins;
  std::vector<StringIndex> edge_origins;
};

/// As Develop, whose conditions hold.
Trace TraceDevelopment(const Genotype& genotype, const SymbolString& string);

/// All of one development.
struct History {
  ActiveRules active;
  Derivation derivation;
  std::optional<Trace> trace;  ///< of the alphabet that has bodies
};

/// Nothing when the string, or its history, would grow beyond its limit.
std::optional<History> DevelopWithHistory(const Genotype& genotype,
                                          const Environment& environment);

}  // namespace plsc
