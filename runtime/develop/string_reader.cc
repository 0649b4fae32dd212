#include "runtime/develop/string_reader.h"

namespace plsc {

namespace {

ModuleType TypeOf(SymbolId symbol) {
  static constexpr std::array<ModuleType, 5> kTypes{
      ModuleType::kCore, ModuleType::kBrick, ModuleType::kVerticalJoint,
      ModuleType::kHorizontalJoint, ModuleType::kTouchSensor};
  return kTypes[static_cast<std::size_t>(symbol)];
}

Node OscillatorOf(int module, const Arguments& arguments) {
  Node node;
  node.type = NodeType::kOscillator;
  node.module = module;
  node.weight = arguments[plasticoding::kWeight];
  node.amplitude = arguments[plasticoding::kAmplitude];
  node.period = arguments[plasticoding::kPeriod];
  node.phase_offset = arguments[plasticoding::kPhaseOffset];
  return node;
}

}  // namespace

Effect StringReader::Mount(SymbolId symbol, const Arguments& arguments) {
  const ModuleType type = TypeOf(symbol);
  const Mounting mounting = body_.Mount(type);
  if (!mounting) return mounting.effect;
  if (IsJoint(type))
    brain_.AddOscillator(OscillatorOf(mounting.module, arguments));
  else if (type == ModuleType::kTouchSensor)
    brain_.AddInput(mounting.module, arguments[plasticoding::kWeight]);
  return mounting.effect;
}

}  // namespace plsc
