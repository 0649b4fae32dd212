// Which symbol goes to which turtle; what the effects are is trace_test's.

#include "runtime/develop/string_reader.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

TEST_CASE("each symbol reaches its turtle and reports its effect",
          "[string_reader]") {
  StringReader reader{DevelopmentSettings{}};
  const Arguments numbers{0.5, 2, 3, 4};
  using namespace plasticoding;
  struct Row {
    const char* why;
    SymbolId symbol;
    Effect effect;
  };
  // In this order, on one robot.
  const std::vector<Row> rows = {
      {"the core is there already", kC, Effect::kStarted},
      {"nowhere to put it", kB, Effect::kNoSlot},
      {"left", kAddLeft, Effect::kSlotUsed},
      {"a joint", kA1, Effect::kMounted},
      {"front", kAddFront, Effect::kSlotUsed},
      {"a sensor", kT, Effect::kMounted},
      {"right", kAddRight, Effect::kSlotUsed},
      {"another joint", kA2, Effect::kMounted},
      {"onto a joint", kMoveLeft, Effect::kModuleReached},
      {"nothing behind it", kMoveRight, Effect::kSideEmpty},
      {"home", kMoveBack, Effect::kModuleReached},
      {"a sensor is no place", kMoveFront, Effect::kSensorThere},
      {"the input again", kMoveRefI, Effect::kNodeReached},
      {"a neuron", kMoveRefN, Effect::kNodeReached},
      {"an edge is there", kAddEdge, Effect::kEdgeExists},
      {"its weight", kMutateEdge, Effect::kEdgeChanged},
      {"a loop", kLoop, Effect::kLoopAdded},
      {"amplitude", kMutateAmp, Effect::kNeuronChanged},
      {"period", kMutatePer, Effect::kNeuronChanged},
      {"phase offset", kMutateOff, Effect::kNeuronChanged},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    CHECK(reader.Read(row.symbol, numbers) == row.effect);
  }
  CHECK(reader.body().body().modules.size() == 4);
  const Phenotype robot = std::move(reader).Take();
  CHECK(robot.body.modules.size() == 4);
  CHECK(robot.brain.nodes.size() == 3);
}

TEST_CASE("the axiom has no arguments, other symbols their own",
          "[string_reader]") {
  const Genotype genotype = test::Robot("rule C -> { C T(0.5) }\n");
  CHECK(ArgumentsOf(genotype, {plasticoding::kC, kNoRule, 0}) == Arguments{});
  CHECK(ArgumentsOf(genotype, {plasticoding::kT, 0, 1})[0] == 0.5);
}

}  // namespace
}  // namespace plsc
