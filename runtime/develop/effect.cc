#include "runtime/develop/effect.h"

#include <array>
#include <cstddef>

namespace plsc {

namespace {

// By Effect.
constexpr std::array<EffectInfo, kEffectCount> kEffects{{
    {"started", true, "the core, where both turtles start"},
    {"slot_used", true, "slot-reference set and used"},
    {"mounted", true, "mounted"},
    {"module_reached", true, "module-reference moved"},
    {"node_reached", true, "reference moved"},
    {"edge_added", true, "edge added"},
    {"loop_added", true, "recurrent edge added"},
    {"edge_changed", true, "weight changed"},
    {"neuron_changed", true, "oscillator changed"},
    {"slot_overwritten", false, "command overwritten before use"},
    {"slot_unused", false, "no module used the command"},
    {"no_slot", false, "slot-reference empty"},
    {"body_full", false, "limit of modules reached, command kept"},
    {"slot_taken", false, "slot taken, command kept"},
    {"cell_taken", false, "cell taken, command kept"},
    {"sensor_on_joint", false, "sensor on a joint, command kept"},
    {"side_empty", false, "nothing there to move to"},
    {"sensor_there", false, "a sensor, which cannot be moved to"},
    {"at_start", false, "already where the way began"},
    {"no_input", false, "no input yet"},
    {"no_neuron", false, "no neuron yet"},
    {"no_nodes", false, "neither input nor neuron yet"},
    {"edge_exists", false, "edge exists"},
    {"loop_exists", false, "recurrent edge exists"},
    {"no_edge", false, "no edge between the references"},
}};

}  // namespace

std::string_view StepOf(SymbolId symbol) {
  if (symbol == plasticoding::kC) return "I";
  switch ((*PlasticodingAlphabet())[symbol].category) {
    case Category::kMounting:
      return "II";
    case Category::kMoving:
      return "V";
    case Category::kControllerMoving:
      return "VI";
    case Category::kControllerChanging:
      return "VII";
    default:
      return "IV";
  }
}

const EffectInfo& InfoOf(Effect effect) {
  return kEffects[static_cast<std::size_t>(effect)];
}

}  // namespace plsc
