// The history of late development, without a second implementation that could
// differ from the first: the very reader of Develop is fed symbol by symbol,
// and what each did is seen by comparing the turtles before and after. What is
// new afterwards in the lists of modules, nodes and edges was made by that
// symbol, because these lists only grow at their ends. What the turtles forget
// (what stood in the way, the value before a change) is asked before the symbol
// is read.
//
// Only a mounting command cannot be told at once: whether its slot is used or
// overwritten (paper, II) shows later, so its event is completed when a module
// takes it or another command comes (`command_`).
//
// Linear in the string, with an event a symbol: for people who ask why, not for
// evolution.

#include "runtime/develop/trace.h"

#include <cassert>
#include <utility>

namespace plsc {

namespace {

bool IsMounting(SymbolId symbol) {
  return symbol >= plasticoding::kAddRight && symbol <= plasticoding::kAddLeft;
}

bool IsModule(SymbolId symbol) {
  return symbol > plasticoding::kC && symbol <= plasticoding::kT;
}

std::optional<Slot> SlotMoved(SymbolId symbol) {
  if (symbol == plasticoding::kMoveFront) return Slot::kFront;
  if (symbol == plasticoding::kMoveLeft) return Slot::kLeft;
  if (symbol == plasticoding::kMoveRight) return Slot::kRight;
  return std::nullopt;
}

template <typename T>
const T& At(const std::vector<T>& values, int index) {
  return values[static_cast<std::size_t>(index)];
}

// Reads symbols one by one and compares the turtles before and after each.
class Tracer {
 public:
  explicit Tracer(const DevelopmentSettings& settings) : reader_(settings) {}

  void Read(SymbolId symbol, const Arguments& arguments);
  Trace Take() && {
    trace_.phenotype = std::move(reader_).Take();
    return std::move(trace_);
  }

 private:
  const Body& body() const { return reader_.body().body(); }
  const Brain& brain() const { return reader_.brain().brain(); }
  /// Index of the symbol that is read now.
  StringIndex now() const {
    return static_cast<StringIndex>(trace_.events.size());
  }

  Event Before(SymbolId symbol) const;
  void BeforeMove(SymbolId symbol, Event& event) const;
  void After(SymbolId symbol, Event& event);
  void AfterBrainCommand(SymbolId symbol, Event& event) const;
  void Credit(Event& event);
  void SetCommand(Event& event);
  void ResolveCommand(const Event& event);

  StringReader reader_;
  Trace trace_{{}, {}, {0}, {}, {}};  // the first symbol makes the core
  /// The mounting command in the slot-reference.
  StringIndex command_ = kNoIndex;
};

// The turtles forget what stood in the way, so it is asked before the symbol
// is read.
Event Tracer::Before(SymbolId symbol) const {
  const BodyTurtle& turtle = reader_.body();
  const BrainTurtle& nodes = reader_.brain();
  Event event;
  event.reference = turtle.reference();
  if (IsModule(symbol)) {
    event.partner = command_;
    if (turtle.slot_reference())
      event.slot = turtle.TargetSlot(*turtle.slot_reference());
  } else if (symbol == plasticoding::kMoveRefI) {
    event.node_before = nodes.input_reference();
  } else if (symbol == plasticoding::kMoveRefN) {
    event.node_before = nodes.neuron_reference();
  } else if (symbol == plasticoding::kAddEdge ||
             symbol == plasticoding::kMutateEdge) {
    event.edge =
        nodes.EdgeBetween(nodes.input_reference(), nodes.neuron_reference());
    if (event.edge != kNoEdge)
      event.before = At(brain().connections, event.edge).weight;
  } else if (symbol == plasticoding::kLoop) {
    event.edge =
        nodes.EdgeBetween(nodes.neuron_reference(), nodes.neuron_reference());
  } else if (symbol >= plasticoding::kMutateAmp) {
    event.node = nodes.neuron_reference();
    if (event.node != kNoNode)
      event.before =
          At(brain().nodes, event.node).*StringReader::ParameterOf(symbol);
  } else {
    BeforeMove(symbol, event);
  }
  return event;
}

void Tracer::BeforeMove(SymbolId symbol, Event& event) const {
  event.slot = SlotMoved(symbol);
  const Module& reference = At(body().modules, event.reference);
  if (event.slot && IsJoint(reference.type)) event.slot = Slot::kFront;
}

// Modules, nodes and edges that are new since `event` began. A symbol makes one
// module and one node at most, but as many edges as nodes are stacked.
void Tracer::Credit(Event& event) {
  const auto known_nodes = static_cast<int>(trace_.node_origins.size());
  const auto known_edges = static_cast<int>(trace_.edge_origins.size());
  trace_.module_origins.resize(body().modules.size(), now());
  trace_.node_origins.resize(brain().nodes.size(), now());
  trace_.edge_origins.resize(brain().connections.size(), now());
  if (trace_.node_origins.size() > static_cast<std::size_t>(known_nodes))
    event.node = known_nodes;
  const auto edges = static_cast<int>(trace_.edge_origins.size());
  if (edges > known_edges) {
    event.edge = known_edges;
    event.edge_count = edges - known_edges;
  }
}

void Tracer::AfterBrainCommand(SymbolId symbol, Event& event) const {
  const BrainTurtle& nodes = reader_.brain();
  switch (event.effect) {
    case Effect::kNodeReached:
      event.node = symbol == plasticoding::kMoveRefI ? nodes.input_reference()
                                                     : nodes.neuron_reference();
      break;
    case Effect::kEdgeChanged:
      event.after = At(brain().connections, event.edge).weight;
      break;
    case Effect::kNeuronChanged:
      event.after =
          At(brain().nodes, event.node).*StringReader::ParameterOf(symbol);
      break;
    default:
      break;
  }
}

void Tracer::After(SymbolId symbol, Event& event) {
  const BodyTurtle& turtle = reader_.body();
  Credit(event);
  switch (event.effect) {
    case Effect::kStarted:
      event.module = 0;
      break;
    case Effect::kMounted:
      event.module = static_cast<int>(body().modules.size()) - 1;
      break;
    case Effect::kModuleReached:
      event.module = turtle.reference();
      break;
    case Effect::kSlotTaken:
    case Effect::kSensorThere:
      event.module = At(body().modules, event.reference).child(*event.slot);
      break;
    case Effect::kCellTaken:
      event.module = turtle.NeighbourAt(*event.slot);
      break;
    default:
      AfterBrainCommand(symbol, event);
  }
}

// II: the command that was waiting is not expressed. Until a module uses the
// new one, it counts as unused.
void Tracer::SetCommand(Event& event) {
  event.effect = Effect::kSlotUnused;
  event.slot = reader_.body().slot_reference();
  if (command_ != kNoIndex) {
    trace_.events[command_].effect = Effect::kSlotOverwritten;
    trace_.events[command_].partner = now();
  }
  command_ = now();
}

void Tracer::ResolveCommand(const Event& event) {
  if (event.effect != Effect::kMounted) return;
  trace_.events[command_].effect = Effect::kSlotUsed;
  trace_.events[command_].partner = now();
  command_ = kNoIndex;
}

void Tracer::Read(SymbolId symbol, const Arguments& arguments) {
  Event event = Before(symbol);
  event.effect = reader_.Read(symbol, arguments);
  if (IsMounting(symbol)) {
    SetCommand(event);
  } else {
    After(symbol, event);
    ResolveCommand(event);
  }
  trace_.events.push_back(event);
}

}  // namespace

Trace TraceDevelopment(const Genotype& genotype, const SymbolString& string) {
  assert(genotype.alphabet->is_built_in());
  assert(!string.empty() && string.front().symbol == plasticoding::kC);
  Tracer tracer(genotype.development);
  for (const Occurrence& occurrence : string)
    tracer.Read(occurrence.symbol, ArgumentsOf(genotype, occurrence));
  return std::move(tracer).Take();
}

std::optional<History> DevelopWithHistory(const Genotype& genotype,
                                          const Environment& environment) {
  History history;
  history.active = Regulate(genotype, environment);
  std::optional<Derivation> derivation =
      DeriveWithHistory(genotype, history.active);
  if (!derivation) return std::nullopt;
  history.derivation = std::move(*derivation);
  if (genotype.alphabet->is_built_in())
    history.trace = TraceDevelopment(genotype, FinalString(history.derivation));
  return history;
}

}  // namespace plsc
