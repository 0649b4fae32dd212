#include "runtime/develop.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "runtime/body_turtle.h"
#include "runtime/brain_turtle.h"

namespace plsc {

namespace {

using Arguments = std::array<double, kMaxParameters>;

// Numbers beyond a node's edges mean its last edge, so a bound far above any
// number of edges changes nothing and keeps the conversion defined.
int EdgeNumber(double argument) {
  return static_cast<int>(std::clamp(argument, 1.0, 1e9));
}

// Reads a string into both turtles.
class Reader {
 public:
  explicit Reader(const DevelopmentSettings& settings)
      : body_(settings.max_modules, settings.move_to_new) {}

  void Read(SymbolId symbol, const Arguments& arguments);
  Phenotype Take() && {
    return {std::move(body_).TakeBody(), std::move(brain_).TakeBrain()};
  }

 private:
  void MountJoint(ModuleType type, const Arguments& arguments);
  void MountSensor(double weight);
  void ReadBodyCommand(SymbolId symbol);
  void ReadBrainCommand(SymbolId symbol, const Arguments& arguments);

  BodyTurtle body_;
  BrainTurtle brain_;
};

void Reader::MountJoint(ModuleType type, const Arguments& arguments) {
  const std::optional<int> module = body_.Mount(type);
  if (!module) return;
  Node node;
  node.type = NodeType::kOscillator;
  node.module = *module;
  node.weight = arguments[plasticoding::kWeight];
  node.amplitude = arguments[plasticoding::kAmplitude];
  node.period = arguments[plasticoding::kPeriod];
  node.phase_offset = arguments[plasticoding::kPhaseOffset];
  brain_.AddOscillator(node);
}

void Reader::MountSensor(double weight) {
  const std::optional<int> module = body_.Mount(ModuleType::kTouchSensor);
  if (module) brain_.AddInput(*module, weight);
}

void Reader::ReadBodyCommand(SymbolId symbol) {
  switch (symbol) {
    case plasticoding::kAddRight:
      return body_.SetSlot(Slot::kRight);
    case plasticoding::kAddFront:
      return body_.SetSlot(Slot::kFront);
    case plasticoding::kAddLeft:
      return body_.SetSlot(Slot::kLeft);
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
  }
}

void Reader::ReadBrainCommand(SymbolId symbol, const Arguments& arguments) {
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
  }
}

void Reader::Read(SymbolId symbol, const Arguments& arguments) {
  if (symbol <= plasticoding::kT) {
    switch (symbol) {
      case plasticoding::kC:
        return;  // unique and first: the turtle starts on it (I)
      case plasticoding::kB:
        body_.Mount(ModuleType::kBrick);
        return;
      case plasticoding::kA1:
        return MountJoint(ModuleType::kVerticalJoint, arguments);
      case plasticoding::kA2:
        return MountJoint(ModuleType::kHorizontalJoint, arguments);
      default:
        return MountSensor(arguments[plasticoding::kWeight]);
    }
  }
  if (symbol <= plasticoding::kMoveLeft) return ReadBodyCommand(symbol);
  ReadBrainCommand(symbol, arguments);
}

}  // namespace

Phenotype Develop(const Genotype& genotype, const SymbolString& string) {
  assert(genotype.alphabet->is_built_in());
  assert(!string.empty() && string.front().symbol == plasticoding::kC);
  static constexpr Arguments kNone{};
  Reader reader(genotype.development);
  for (const Occurrence& occurrence : string) {
    const Arguments& arguments = occurrence.rule == kNoRule
                                     ? kNone
                                     : genotype.rules[occurrence.rule]
                                           .production[occurrence.position]
                                           .arguments;
    reader.Read(occurrence.symbol, arguments);
  }
  return std::move(reader).Take();
}

std::optional<Phenotype> Develop(const Genotype& genotype,
                                 const Environment& environment) {
  const std::optional<SymbolString> string =
      Derive(genotype, Regulate(genotype, environment));
  if (!string) return std::nullopt;
  return Develop(genotype, *string);
}

}  // namespace plsc
