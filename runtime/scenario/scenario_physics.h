#pragma once

// The constants of physics and servo in YAML: one table for reading, printing
// and the round trip between them.

#include <set>
#include <string>

#include "grammar/enum_names.h"
#include "runtime/text/yaml_reader.h"
#include "sim/options.h"

namespace plsc {

inline constexpr EnumNames<EngineKind, 2> kEngineNames{
    {{EngineKind::kOde, "ode"}, {EngineKind::kArticulated, "articulated"}}};
inline constexpr EnumNames<Refresh, 2> kRefreshNames{
    {{Refresh::kExact, "exact"}, {Refresh::kLate, "late"}}};
inline constexpr EnumNames<ControllerMode, 2> kControllerNames{
    {{ControllerMode::kOpenLoop, "open_loop"},
     {ControllerMode::kCoupled, "coupled"}}};

/// Keys that a map gave, with their values.
struct PhysicsPatch {
  PhysicsOptions values;
  std::set<std::string> given;
};
PhysicsPatch ReadPhysics(YamlMap map);

/// `base`, but what the patch gives.
PhysicsOptions Patched(PhysicsOptions base, const PhysicsPatch& patch);

/// A line a key.
std::string PrintPhysics(const PhysicsOptions& physics,
                         const std::string& blanks);

/// "{step: 3 ms}": the keys whose values are not those of `usual`.
std::string PrintPhysicsChanges(const PhysicsOptions& physics,
                                const PhysicsOptions& usual);

/// `otherwise` where the map gives nothing.
ServoOptions ReadServo(YamlMap map, const ServoOptions& otherwise);
std::string PrintServo(const ServoOptions& servo, const std::string& blanks);

}  // namespace plsc
