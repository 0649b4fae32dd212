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

Effect StringReader::ReadBodyCommand(SymbolId symbol) {
  switch (symbol) {
    case plasticoding::kAddRight:
      return SetSlot(Slot::kRight);
    case plasticoding::kAddFront:
      return SetSlot(Slot::kFront);
    case plasticoding::kAddLeft:
      return SetSlot(Slot::kLeft);
    case plasticoding::kMoveBack:
      return body_.MoveBack();
    case plasticoding::kMoveRight:
      return body_.Move(Slot::kRight);
    case plasticoding::kMoveFront:
      return body_.Move(Slot::kFront);
    case plasticoding::kMoveLeft:
      return body_.Move(Slot::kLeft);
    default:
      assert(false);
      return Effect::kStarted;
  }
}

Effect StringReader::ReadBrainCommand(SymbolId symbol,
                                      const Arguments& arguments) {
  const double amount = arguments[0];
  switch (symbol) {
    case plasticoding::kMoveRefI:
      return brain_.MoveInputReference(EdgeNumber(arguments[0]),
                                       EdgeNumber(arguments[1]));
    case plasticoding::kMoveRefN:
      return brain_.MoveNeuronReference(EdgeNumber(arguments[0]),
                                        EdgeNumber(arguments[1]));
    case plasticoding::kAddEdge:
      return brain_.AddEdge(amount);
    case plasticoding::kLoop:
      return brain_.AddLoop(amount);
    case plasticoding::kMutateEdge:
      return brain_.MutateEdge(amount);
    case plasticoding::kMutateAmp:
      return brain_.MutateAmplitude(amount);
    case plasticoding::kMutatePer:
      return brain_.MutatePeriod(amount);
    case plasticoding::kMutateOff:
      return brain_.MutatePhaseOffset(amount);
    default:
      assert(false);
      return Effect::kStarted;
  }
}

Effect StringReader::Read(SymbolId symbol, const Arguments& arguments) {
  if (symbol <= plasticoding::kT) {
    switch (symbol) {
      case plasticoding::kC:
        return Effect::kStarted;  // unique and first: the turtle starts on it
                                  // (I)
      case plasticoding::kB:
        return body_.Mount(ModuleType::kBrick).effect;
      case plasticoding::kA1:
        return MountJoint(ModuleType::kVerticalJoint, arguments);
      case plasticoding::kA2:
        return MountJoint(ModuleType::kHorizontalJoint, arguments);
      default:
        return MountSensor(arguments[plasticoding::kWeight]);
    }
  }
  if (symbol <= plasticoding::kMoveLeft) return ReadBodyCommand(symbol);
  return ReadBrainCommand(symbol, arguments);
}

}  // namespace plsc
