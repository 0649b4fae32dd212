#include "runtime/develop/effect.h"

#include <catch2/catch.hpp>
#include <set>

namespace plsc {
namespace {

TEST_CASE("every effect has a name of its own and a text", "[effect]") {
  std::set<std::string_view> names;
  for (int i = 0; i < kEffectCount; ++i) {
    const EffectInfo& info = InfoOf(static_cast<Effect>(i));
    CHECK_FALSE(info.name.empty());
    CHECK_FALSE(info.text.empty());
    CHECK(names.insert(info.name).second);
  }
  CHECK(static_cast<int>(Effect::kNoEdge) == kEffectCount - 1);
}

TEST_CASE("the table is in the order of the enum", "[effect]") {
  CHECK(InfoOf(Effect::kStarted).name == "started");
  CHECK(InfoOf(Effect::kNeuronChanged).name == "neuron_changed");
  CHECK(InfoOf(Effect::kNeuronChanged).is_expressed);
  CHECK(InfoOf(Effect::kSlotOverwritten).name == "slot_overwritten");
  CHECK_FALSE(InfoOf(Effect::kSlotOverwritten).is_expressed);
  CHECK(InfoOf(Effect::kSensorThere).name == "sensor_there");
  CHECK(InfoOf(Effect::kNoEdge).name == "no_edge");
}

TEST_CASE("each category of symbols has its step of the paper", "[effect]") {
  CHECK(StepOf(plasticoding::kC) == "I");
  CHECK(StepOf(plasticoding::kB) == "IV");
  CHECK(StepOf(plasticoding::kT) == "IV");
  CHECK(StepOf(plasticoding::kAddLeft) == "II");
  CHECK(StepOf(plasticoding::kMoveBack) == "V");
  CHECK(StepOf(plasticoding::kMoveRefN) == "VI");
  CHECK(StepOf(plasticoding::kLoop) == "VII");
  CHECK(StepOf(plasticoding::kMutateOff) == "VII");
}

}  // namespace
}  // namespace plsc
