#include "runtime/string_reader.h"

#include <algorithm>
#include <cassert>

namespace plsc {

namespace {

// Numbers beyond a node's edges mean its last edge, so a bound far above any
// number of edges changes nothing and keeps the conversion defined.
int EdgeNumber(double argument) {
  return static_cast<int>(std::clamp(argument, 1.0, 1e9));
}

// Of the three mounting or moving commands whose first is `right`: both stand
// in the table in the order right, front, left.
Slot SideOf(SymbolId symbol, SymbolId right) {
  constexpr std::array<Slot, 3> kSides{Slot::kRight, Slot::kFront, Slot::kLeft};
  return kSides[static_cast<std::size_t>(symbol) -
                static_cast<std::size_t>(right)];
}

}  // namespace

Effect StringReader::MountJoint(ModuleType type, const Arguments& arguments) {
  const Mounting mounting = body_.Mount(type);
  if (!mounting) return mounting.effect;
  Node node;
  node.type = NodeType::kOscillator;
  node.module = mounting.module;
  node.weight = arguments[plasticoding::kWeight];
  node.amplitude = arguments[plasticoding::kAmplitude];
  node.period = arguments[plasticoding::kPeriod];
  node.phase_offset = arguments[plasticoding::kPhaseOffset];
  brain_.AddOscillator(node);
  return mounting.effect;
}

Effect StringReader::MountSensor(double weight) {
  const Mounting mounting = body_.Mount(ModuleType::kTouchSensor);
  if (mounting) brain_.AddInput(mounting.module, weight);
  return mounting.effect;
}

// One flat switch, and one case for symbols that differ in a side only: what
// comes next in a string is hard to predict, so branches are most of the cost.
Effect StringReader::Read(SymbolId symbol, const Arguments& arguments) {
  switch (symbol) {
    case plasticoding::kC:
      return Effect::kStarted;  // unique and first: the turtle starts on it (I)
    case plasticoding::kB:
      return body_.Mount(ModuleType::kBrick).effect;
    case plasticoding::kA1:
      return MountJoint(ModuleType::kVerticalJoint, arguments);
    case plasticoding::kA2:
      return MountJoint(ModuleType::kHorizontalJoint, arguments);
    case plasticoding::kT:
      return MountSensor(arguments[plasticoding::kWeight]);
    case plasticoding::kAddRight:
    case plasticoding::kAddFront:
    case plasticoding::kAddLeft:
      body_.SetSlot(SideOf(symbol, plasticoding::kAddRight));
      return Effect::kSlotUsed;
    case plasticoding::kMoveBack:
      return body_.MoveBack();
    case plasticoding::kMoveRight:
    case plasticoding::kMoveFront:
    case plasticoding::kMoveLeft:
      return body_.Move(SideOf(symbol, plasticoding::kMoveRight));
    case plasticoding::kMoveRefI:
      return brain_.MoveInputReference(EdgeNumber(arguments[0]),
                                       EdgeNumber(arguments[1]));
    case plasticoding::kMoveRefN:
      return brain_.MoveNeuronReference(EdgeNumber(arguments[0]),
                                        EdgeNumber(arguments[1]));
    case plasticoding::kAddEdge:
      return brain_.AddEdge(arguments[0]);
    case plasticoding::kLoop:
      return brain_.AddLoop(arguments[0]);
    case plasticoding::kMutateEdge:
      return brain_.MutateEdge(arguments[0]);
    case plasticoding::kMutateAmp:
      return brain_.MutateAmplitude(arguments[0]);
    case plasticoding::kMutatePer:
      return brain_.MutatePeriod(arguments[0]);
    case plasticoding::kMutateOff:
      return brain_.MutatePhaseOffset(arguments[0]);
  }
  assert(false);
  return Effect::kStarted;
}

}  // namespace plsc
