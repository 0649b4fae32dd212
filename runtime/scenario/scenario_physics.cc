#include "runtime/scenario/scenario_physics.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

namespace plsc {

namespace {

template <typename Options>
struct NumberKey {
  const char* name;
  double Options::*field;
  Quantity quantity;
};

struct IntKey {
  const char* name;
  int PhysicsOptions::*field;
  int low, high;
};

using enum Dimension;
using P = PhysicsOptions;
using S = ServoOptions;

// In the order of PhysicsOptions, which explains the fields. Limits are those
// of plausible worlds, wide enough for any experiment; beyond them a number is
// a slip of the pen, or ODE fails.
constexpr NumberKey<P> kPhysicsKeys[] = {
    {"step", &P::step, {kTime, 0, 0.1, true}},
    {"gravity", &P::gravity, {kAcceleration, 0, 1000}},
    {"world_erp", &P::world_erp, {kNumber, 0, 1}},
    {"world_cfm", &P::world_cfm, {kNumber, 0, 1}},
    {"friction", &P::friction, {kNumber, 0, 1000}},
    {"slip", &P::slip, {kSlip, 0, 1000}},
    {"robot_kp", &P::robot_kp, {kStiffness, 0, 1e12, true}},
    {"robot_kd", &P::robot_kd, {kViscosity, 0, 1e12}},
    {"ground_kp", &P::ground_kp, {kStiffness, 0, 1e12, true}},
    {"ground_kd", &P::ground_kd, {kViscosity, 0, 1e12}},
    {"damping", &P::damping, {kNumber, 0, 1}},
    {"correcting_speed", &P::correcting_speed, {kSpeed, 0, 1e6}},
    {"surface_layer", &P::surface_layer, {kLength, 0, 0.1}},
    {"max_speed", &P::max_speed, {kSpeed, 0, 1e6, true}},
    {"max_spin", &P::max_spin, {kAngularSpeed, 0, 1e6, true}},
    {"max_solver_failures", &P::max_solver_failures, {kNumber, 0, 1e9}},
};

constexpr IntKey kPhysicsIntKeys[] = {
    {"solver_iterations", &P::solver_iterations, 1, 100000},
    {"max_direct_links", &P::max_direct_links, 0, 100000},
};

constexpr NumberKey<S> kServoKeys[] = {
    {"range", &S::range, {kAngle, 0, std::numbers::pi, true}},
    {"gain", &S::gain, {kRate, 0, 1000, true}},
    {"max_speed", &S::max_speed, {kAngularSpeed, 0, 1000, true}},
    {"max_torque", &S::max_torque, {kTorque, 0, 1000, true}},
    {"update_rate", &S::update_rate, {kFrequency, 0, 1e4, true}},
};

/// Becomes a value of any type, to try how many of them an aggregate takes.
struct AnyField {
  template <typename T>
  operator T() const;
};

template <typename Options, typename... Fields>
consteval std::size_t FieldCount() {
  if constexpr (requires { Options{Fields{}..., AnyField{}}; })
    return FieldCount<Options, Fields..., AnyField>();
  else
    return sizeof...(Fields);
}

// A field more must get its key here and in docs/experiments.md, or results
// would depend on what no file says. `engine`, `solver` and `refresh` are read
// by name.
static_assert(FieldCount<PhysicsOptions>() ==
              std::size(kPhysicsKeys) + std::size(kPhysicsIntKeys) + 2);
static_assert(FieldCount<ServoOptions>() == std::size(kServoKeys) + 1);

constexpr EnumNames<Solver, 2> kSolverNames{
    {{Solver::kDirect, "direct"}, {Solver::kIterative, "iterative"}}};

using Printed = std::vector<std::pair<std::string, std::string>>;

Printed PrintedKeys(const PhysicsOptions& physics) {
  Printed lines;
  lines.emplace_back("engine", NameIn(kEngineNames, physics.engine));
  lines.emplace_back("solver", NameIn(kSolverNames, physics.solver));
  for (const IntKey& key : kPhysicsIntKeys)
    lines.emplace_back(key.name, std::to_string(physics.*key.field));
  for (const auto& key : kPhysicsKeys)
    lines.emplace_back(
        key.name, PrintQuantity(physics.*key.field, key.quantity.dimension));
  return lines;
}

}  // namespace

PhysicsPatch ReadPhysics(YamlMap map) {
  PhysicsPatch patch;
  PhysicsOptions& physics = patch.values;
  const auto note = [&](const char* name) {
    if (map.Find(name)) patch.given.insert(name);
  };
  note("engine");
  physics.engine = map.Choice("engine", physics.engine, kEngineNames);
  note("solver");
  physics.solver = map.Choice("solver", physics.solver, kSolverNames);
  for (const IntKey& key : kPhysicsIntKeys) {
    note(key.name);
    physics.*key.field =
        map.Int(key.name, physics.*key.field, key.low, key.high);
  }
  for (const auto& key : kPhysicsKeys) {
    note(key.name);
    physics.*key.field = map.Number(key.name, physics.*key.field, key.quantity);
  }
  map.Close();
  return patch;
}

PhysicsOptions Patched(PhysicsOptions base, const PhysicsPatch& patch) {
  if (patch.given.contains("engine")) base.engine = patch.values.engine;
  if (patch.given.contains("solver")) base.solver = patch.values.solver;
  for (const IntKey& key : kPhysicsIntKeys)
    if (patch.given.contains(key.name))
      base.*key.field = patch.values.*key.field;
  for (const auto& key : kPhysicsKeys)
    if (patch.given.contains(key.name))
      base.*key.field = patch.values.*key.field;
  return base;
}

std::string PrintPhysics(const PhysicsOptions& physics,
                         const std::string& blanks) {
  std::string text;
  for (const auto& [name, value] : PrintedKeys(physics))
    text += fmt::format("{}{}: {}\n", blanks, name, value);
  return text;
}

std::string PrintPhysicsChanges(const PhysicsOptions& physics,
                                const PhysicsOptions& usual) {
  const Printed lines = PrintedKeys(physics), others = PrintedKeys(usual);
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i] != others[i])
      changes.push_back(fmt::format("{}: {}", lines[i].first, lines[i].second));
  return fmt::format("{{{}}}", fmt::join(changes, ", "));
}

ServoOptions ReadServo(YamlMap map, const ServoOptions& otherwise) {
  ServoOptions servo = otherwise;
  for (const auto& key : kServoKeys)
    servo.*key.field = map.Number(key.name, servo.*key.field, key.quantity);
  servo.refresh = map.Choice("refresh", servo.refresh, kRefreshNames);
  map.Close();
  return servo;
}

std::string PrintServo(const ServoOptions& servo, const std::string& blanks) {
  std::string text;
  for (const auto& key : kServoKeys)
    text +=
        fmt::format("{}{}: {}\n", blanks, key.name,
                    PrintQuantity(servo.*key.field, key.quantity.dimension));
  text += fmt::format("{}refresh: {}\n", blanks,
                      NameIn(kRefreshNames, servo.refresh));
  return text;
}

}  // namespace plsc
