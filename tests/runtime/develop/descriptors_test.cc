// Formulas by hand on small bodies; tests/runtime/cli/reference_test.cc
// compares all of them with the authors' results.

#include "runtime/develop/descriptors.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/develop/body_turtle.h"

namespace plsc {
namespace {

struct Step {
  Slot slot;
  ModuleType type;
  bool descend = false;
};

Body Build(const std::vector<Step>& steps) {
  BodyTurtle turtle(15, false);
  for (const Step& step : steps) {
    turtle.SetSlot(step.slot);
    REQUIRE(turtle.Mount(step.type));
    if (step.descend) turtle.Move(step.slot);
  }
  return turtle.body();
}

TEST_CASE("a lone core has size 1 and four free slots", "[descriptors]") {
  const BodyDescriptors d = DescribeBody(Build({}));
  CHECK(d.absolute_size == 1);
  CHECK(d.free_slots == 4);
  CHECK(d.coverage == 1);
  CHECK(d.proportion == 1);
  CHECK(d.limbs == 0);
  CHECK(d.symmetry == 0);
}

TEST_CASE("a cross of bricks is one branching, four limbs, symmetric",
          "[descriptors]") {
  using enum ModuleType;
  const BodyDescriptors d = DescribeBody(Build({{Slot::kFront, kBrick},
                                                {Slot::kLeft, kBrick},
                                                {Slot::kRight, kBrick},
                                                {Slot::kLeft, kBrick}}));
  CHECK(d.absolute_size == 5);
  CHECK(d.branching_modules_count == 1);
  CHECK(d.branching == 1);
  CHECK(d.extremities == 4);
  CHECK(d.limbs == 1);
  CHECK(d.width == 3);
  CHECK(d.height == 3);
  CHECK(d.coverage == Approx(5.0 / 9));
  CHECK(d.symmetry == 1);
  CHECK(d.free_slots == 12);
}

TEST_CASE("a line to one side is no symmetry", "[descriptors]") {
  using enum ModuleType;
  const BodyDescriptors d =
      DescribeBody(Build({{Slot::kRight, kHorizontalJoint, true},
                          {Slot::kFront, kBrick, true},
                          {Slot::kFront, kTouchSensor}}));
  CHECK(d.symmetry == 0);
  CHECK(d.width == 3);
  CHECK(d.height == 1);
  CHECK(d.proportion == Approx(1.0 / 3));
  CHECK(d.hinge_count == 1);
  CHECK(d.active_hinges_count == 1);
  CHECK(d.extensiveness == 1);
  CHECK(d.length_of_limbs == 1);
  CHECK(d.joints == 1);
  // Core 4 - 1, joint 0 - 1, brick 3.
  CHECK(d.sensors == Approx(1 / d.free_slots));
}

Phenotype TwoOscillators(bool with_brick) {
  using enum ModuleType;
  std::vector<Step> steps{{Slot::kFront, kTouchSensor},
                          {Slot::kLeft, kHorizontalJoint},
                          {Slot::kRight, kVerticalJoint, with_brick}};
  if (with_brick) steps.push_back({Slot::kFront, kBrick});
  Phenotype phenotype;
  phenotype.body = Build(steps);
  Node input;
  input.module = 1;
  Node first{NodeType::kOscillator, 2, 0.5, 2, 4, 6};
  Node second{NodeType::kOscillator, 3, 0.5, 4, 8, 6};
  phenotype.brain.nodes = {input, first, second};
  phenotype.brain.connections = {{0, 1, 0.5}, {2, 2, -1}};
  return phenotype;
}

double Sigmoid(double x) {
  return 1 / (1 + std::exp(-x));
}

TEST_CASE("controller descriptors follow their formulas", "[descriptors]") {
  const BrainDescriptors d = DescribeBrain(TwoOscillators(true));
  CHECK(d.avg_amplitude == Approx(0.3));
  CHECK(d.avg_period == Approx(0.6));
  CHECK(d.avg_phase_offset == Approx(0.6));
  CHECK(d.dev_amplitude == Approx(Sigmoid(1)));
  CHECK(d.dev_period == Approx(Sigmoid(2)));
  CHECK(d.dev_phase_offset == Approx(0.5));
  CHECK(d.avg_inter_dev_params == Approx(Sigmoid(1)));
  CHECK(d.sensors_reach == Approx(0.5));
  CHECK(d.recurrence == Approx(0.5));
  CHECK(d.synaptic_reception == 0);  // nothing inhibits
}

TEST_CASE("inhibiting and exciting weights balance", "[descriptors]") {
  Phenotype phenotype = TwoOscillators(true);
  phenotype.brain.connections = {
      {0, 1, 0.5}, {0, 1, -0.25}, {0, 2, -1}, {0, 2, 1}, {2, 2, -1}};
  // Ratios 0.5 and 1 (the loop is left out); the median of two is between.
  CHECK(DescribeBrain(phenotype).synaptic_reception == Approx(0.75));
}

TEST_CASE("controller descriptors are zero while no joint carries a module",
          "[descriptors]") {
  for (const NamedValue& value : List(DescribeBrain(TwoOscillators(false)))) {
    INFO(value.name);
    CHECK(value.value == 0);
  }
}

TEST_CASE("descriptors are listed under the authors' names", "[descriptors]") {
  const auto body = List(DescribeBody(Build({})));
  REQUIRE(body.size() == 20);
  CHECK(body.front().name == "branching");
  CHECK(body[16].name == "absolute_size");
  CHECK(body[16].value == 1);
  CHECK(body[16].is_count);
  CHECK(List(BrainDescriptors{}).size() == 11);
}

TEST_CASE("descriptors come back from their lists", "[descriptors]") {
  // A number of its own each, whole ones for the counts.
  const auto numbers = [](const std::vector<NamedValue>& list) {
    std::vector<double> values;
    for (const NamedValue& value : list)
      values.push_back(static_cast<double>(values.size() + 1) +
                       (value.is_count ? 0 : 0.1));
    return values;
  };
  const auto values = [](const std::vector<NamedValue>& list) {
    std::vector<double> all;
    for (const NamedValue& value : list) all.push_back(value.value);
    return all;
  };
  const auto body = numbers(List(BodyDescriptors{}));
  CHECK(values(List(BodyDescriptorsOf(body))) == body);
  const auto brain = numbers(List(BrainDescriptors{}));
  CHECK(values(List(BrainDescriptorsOf(brain))) == brain);
  const auto behaviour = numbers(List(Behaviour{}));
  CHECK(values(List(BehaviourOf(behaviour))) == behaviour);
  CHECK(BehaviourOf(behaviour).is_valid);
}

}  // namespace
}  // namespace plsc
