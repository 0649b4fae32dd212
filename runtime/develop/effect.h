#pragma once

// What one symbol of the string did in late development, or which of the
// paper's reasons ("Mapping stage 2", steps I to VII) kept it from being
// expressed. The turtles return it for each symbol they read; plain
// development ignores it, runtime/develop/trace collects it.

#include <cstdint>
#include <string_view>

#include "compiler/alphabet.h"

namespace plsc {

enum class Effect : std::uint8_t {
  // Expressed.
  kStarted,        ///< C: the core, where the turtles start
  kSlotUsed,       ///< a mounting command that a module then used
  kMounted,        ///< a module
  kModuleReached,  ///< the module-reference moved
  kNodeReached,    ///< the input- or neuron-reference moved (or came back)
  kEdgeAdded,      ///< add_edge
  kLoopAdded,      ///< loop
  kEdgeChanged,    ///< mutate_edge
  kNeuronChanged,  ///< mutate_amp, mutate_per, mutate_off
  // Not expressed.
  kSlotOverwritten,  ///< the next mounting command came before a module
  kSlotUnused,       ///< no module came after it that could be mounted
  kNoSlot,           ///< a module while the slot-reference is empty
  kBodyFull,         ///< max_modules are mounted
  kSlotTaken,        ///< a module or sensor sits there
  kCellTaken,        ///< the module would intersect another
  kSensorOnJoint,
  kSideEmpty,    ///< nothing to move to
  kSensorThere,  ///< a sensor, which cannot be moved to
  kAtStart,      ///< move_back where the way began
  kNoInput,      ///< no sensor is mounted yet
  kNoNeuron,     ///< no joint is mounted yet
  kNoNodes,      ///< neither is
  kEdgeExists,   ///< add_edge
  kLoopExists,   ///< loop
  kNoEdge,       ///< mutate_edge between nodes that have none
};
inline constexpr int kEffectCount = 25;

struct EffectInfo {
  std::string_view name;  ///< in JSON: "slot_taken"
  bool is_expressed = false;
  std::string_view text;  ///< for people, without the particulars
};

const EffectInfo& InfoOf(Effect effect);

/// The paper's numeral of the step that reads a symbol of `plasticoding`:
/// C I, mounting commands II, modules IV (III is finding their command), moving
/// V, controller-moving VI, controller-changing VII.
std::string_view StepOf(SymbolId symbol);

}  // namespace plsc
