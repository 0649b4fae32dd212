// The authors' names are kept where they say what is meant; what the paper
// calls otherwise, and everybody asks for, has the paper's word as well.

#include "runtime/formula/quantities.h"

#include <algorithm>
#include <vector>

namespace plsc {

namespace {

constexpr QuantityInfo kQuantities[] = {
    // Body.
    {"branching", "", "branching modules, of those that the size allows"},
    {"branching_modules_count", "", "cores with 4 and bricks with 3 children"},
    {"limbs", "", "extremities, of the most that the size allows"},
    {"extremities", "", "modules but the core without children"},
    {"length_of_limbs", "", "extensiveness over size - 2"},
    {"extensiveness", "", "modules but the core with one child"},
    {"coverage", "", "size over the area of the box around the body"},
    {"joints", "", "joints that carry a module, over size - 2"},
    {"hinge_count", "", "joints, also those that carry nothing"},
    {"active_hinges_count", "", "joints that carry a module"},
    {"brick_count", "", "bricks"},
    {"touch_sensor_count", "", "touch sensors"},
    {"brick_sensor_count", "", "0: there are none"},
    {"proportion", "", "the shorter over the longer side"},
    {"width", "", "modules from left to right"},
    {"height", "", "modules from back to front"},
    {"size", "", "modules without sensors", "absolute_size"},
    {"sensors", "", "touch sensors over free slots"},
    {"symmetry", "", "share of modules with a mirror image"},
    {"free_slots", "", "free slots of core and bricks; 0.0001 if none"},
    // Brain.
    {"avg_period", "", "median period of oscillators over 10"},
    {"dev_period", "", "how much periods differ, 0.5 to 1"},
    {"avg_phase_offset", "", "median phase offset over 10"},
    {"dev_phase_offset", "", "how much phase offsets differ, 0.5 to 1"},
    {"avg_amplitude", "", "median amplitude over 10"},
    {"dev_amplitude", "", "how much amplitudes differ, 0.5 to 1"},
    {"avg_intra_dev_params", "", "how much the parameters of one differ"},
    {"avg_inter_dev_params", "", "how much parameters differ between all"},
    {"sensors_reach", "", "share of oscillators that a sensor acts on"},
    {"recurrence", "", "share of oscillators with a loop"},
    {"synaptic_reception", "", "balance of weights into an oscillator"},
    // Behaviour.
    {"velocity", "m/s", "length of the path over time"},
    {"displacement_velocity", "m/s",
     "straight way from start to end over time"},
    {"speed", "m/s", "the paper's Speed: way along +y, uphill, over time",
     "displacement_velocity_hill"},
    {"balance", "", "the paper's Balance, 0.25 to 1", "head_balance"},
    {"contacts", "", "mean contact points over size"},
    {"servo_error_median", "rad/s", "median error of servos"},
    {"servo_error_worst", "rad/s", "largest error of servos"},
    {"core_turns", "1/m", "turns of the core by rolling, a metre of path"},
    {"final_x", "m", "place at the end, to the right of the start's heading"},
    {"final_y", "m", "place at the end, in the start's heading and uphill"},
    {"final_z", "m", "height at the end"},
    {"heading", "rad", "heading at the end, 0 as at birth, left is more"},
    {"straightness", "", "straight way over length of the path, 0 to 1"},
    {"turning", "rad", "all changes of the heading, without their signs"},
    {"energy", "J", "work of the servos: torque times speed, without signs"},
    {"cost_of_transport", "", "energy over weight and straight way"},
    {"target_distance", "m", "to the nearest target at the end"},
    // What follows.
    {"duration", "s", "time lived in the season"},
    {"displacement", "m", "straight way from start to end"},
    {"path", "m", "length of the path, as seen from above"},
};

}  // namespace

std::span<const QuantityInfo> Quantities() {
  return kQuantities;
}

std::optional<std::size_t> FindQuantity(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kQuantities); ++i)
    if (kQuantities[i].name == name ||
        (!name.empty() && kQuantities[i].column == name))
      return i;
  return std::nullopt;
}

std::span<const std::string_view> QuantityNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const QuantityInfo& one : kQuantities) {
      all.push_back(one.name);
      if (!one.column.empty()) all.push_back(one.column);
    }
    return all;
  }();
  return names;
}

}  // namespace plsc
