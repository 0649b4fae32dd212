#include "runtime/history/event_text.h"

#include <fmt/format.h>

#include "grammar/number.h"
#include "runtime/develop/part_names.h"

namespace plsc {

namespace {

// Writes the sentence of one event.
class EventSentence {
 public:
  EventSentence(const HistoryView& view, StringIndex index)
      : view_(view),
        trace_(*view.history.trace),
        event_(trace_.events[index]),
        symbol_(view.At(index).occurrence.symbol) {}

  std::string Text() const {
    const EffectInfo& info = InfoOf(event_.effect);
    if (info.is_expressed) return Done();
    return fmt::format("not expressed ({}): {}", StepOf(symbol_), Reason());
  }

 private:
  std::string ModuleText(int index) const {
    const Body& body = trace_.phenotype.body;
    const Module& module = body.modules[static_cast<std::size_t>(index)];
    return fmt::format(
        "{} {} ({})",
        module.type == ModuleType::kTouchSensor ? "sensor" : "module",
        ModuleId(body, index), ModuleName(module.type));
  }
  std::string SideText() const {
    return fmt::format("the {} of {}", SlotName(*event_.slot),
                       ModuleText(event_.reference));
  }
  std::string EdgeText(int index) const {
    return EdgeName(
        trace_.phenotype.brain.connections[static_cast<std::size_t>(index)]);
  }
  std::string PartnerText() const {
    return fmt::format(
        "{} (symbol {})",
        NameOf(view_.genotype, view_.At(event_.partner).occurrence),
        event_.partner + 1);
  }
  Slot CommandSlot() const { return *trace_.events[event_.partner].slot; }

  std::string Mounted() const;
  std::string NodeReached() const;
  std::string NeuronChanged() const;
  std::string Done() const;
  std::string Reason() const;

  const HistoryView& view_;
  const Trace& trace_;
  const Event& event_;
  SymbolId symbol_;
};

std::string EventSentence::Mounted() const {
  std::string text =
      fmt::format("mounted as {} at {} by {}", ModuleText(event_.module),
                  SideText(), PartnerText());
  if (CommandSlot() != *event_.slot)
    text += *event_.slot == Slot::kBack
                ? ", as the core's other sides are taken"
                : ", as a joint has no other side";
  if (event_.node != kNoNode) text += "; made " + NodeName(event_.node);
  for (int i = 0; i < event_.edge_count; ++i)
    text += (i == 0 ? " and " : ", ") + EdgeText(event_.edge + i);
  return text;
}

std::string EventSentence::NodeReached() const {
  const char* reference =
      symbol_ == plasticoding::kMoveRefI ? "input" : "neuron";
  if (event_.node == event_.node_before)
    return fmt::format("{}-reference came back to {}", reference,
                       NodeName(event_.node));
  return fmt::format("{}-reference moved from {} to {}", reference,
                     NodeName(event_.node_before), NodeName(event_.node));
}

std::string EventSentence::NeuronChanged() const {
  const char* parameter = symbol_ == plasticoding::kMutateAmp ? "amplitude"
                          : symbol_ == plasticoding::kMutatePer
                              ? "period"
                              : "phase offset";
  return fmt::format("{} of {} from {} to {}", parameter, NodeName(event_.node),
                     PrintNumber(event_.before), PrintNumber(event_.after));
}

std::string EventSentence::Done() const {
  switch (event_.effect) {
    case Effect::kSlotUsed:
      return fmt::format("slot-reference := {}, used by {}",
                         SlotName(*event_.slot), PartnerText());
    case Effect::kMounted:
      return Mounted();
    case Effect::kModuleReached:
      return "module-reference moved to " + ModuleText(event_.module);
    case Effect::kNodeReached:
      return NodeReached();
    case Effect::kEdgeAdded:
    case Effect::kLoopAdded:
      return fmt::format("made {} {}",
                         event_.effect == Effect::kEdgeAdded ? "edge" : "loop",
                         EdgeText(event_.edge));
    case Effect::kEdgeChanged:
      return fmt::format("weight of {} from {} to {}", EdgeText(event_.edge),
                         PrintNumber(event_.before), PrintNumber(event_.after));
    case Effect::kNeuronChanged:
      return NeuronChanged();
    default:
      return std::string(InfoOf(event_.effect).text);
  }
}

std::string EventSentence::Reason() const {
  switch (event_.effect) {
    case Effect::kSlotOverwritten:
      return "command overwritten before use, by " + PartnerText();
    case Effect::kBodyFull:
      return fmt::format("limit of {} modules reached, command kept",
                         view_.genotype.development.max_modules);
    case Effect::kSlotTaken:
      return fmt::format("{} is taken by {}, command kept", SideText(),
                         ModuleText(event_.module));
    case Effect::kCellTaken:
      return fmt::format("the cell at {} is taken by {}, command kept",
                         SideText(), ModuleText(event_.module));
    case Effect::kSensorOnJoint:
      return fmt::format("sensor on a joint, {}, command kept",
                         ModuleText(event_.reference));
    case Effect::kSideEmpty:
      return fmt::format("nothing to move to at {}", SideText());
    case Effect::kSensorThere:
      return fmt::format("{} at {} cannot be moved to",
                         ModuleText(event_.module), SideText());
    case Effect::kEdgeExists:
    case Effect::kLoopExists:
      return fmt::format("{} exists", EdgeText(event_.edge));
    default:
      return std::string(InfoOf(event_.effect).text);
  }
}

}  // namespace

std::string EventText(const HistoryView& view, StringIndex index) {
  return EventSentence(view, index).Text();
}

}  // namespace plsc
