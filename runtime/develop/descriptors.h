#pragma once

// Morphological and controller descriptors, under the authors' names and by
// their formulas (paper, "Robot Descriptors"; docs/development.md), so that
// results compare with theirs.

#include <string_view>
#include <vector>

#include "sim/measures.h"
#include "sim/phenotype.h"

namespace plsc {

/// Authors' program, measure_body.py:57-384. "Size" is absolute_size; children
/// and modules are those that are no touch sensors. Numbers without a unit are
/// shares from 0 to 1 if nothing else is said.
struct BodyDescriptors {
  /// Of the branching modules that the size allows, floor((Size - 2) / 3); 0
  /// below Size 5.
  double branching = 0;
  int branching_modules_count = 0;  ///< cores with 4, bricks with 3 children
  /// Extremities, of the most that the size allows.
  double limbs = 0;
  int extremities = 0;  ///< modules but the core without children
  /// Extensiveness over Size - 2; 0 below Size 3.
  double length_of_limbs = 0;
  int extensiveness = 0;  ///< modules but the core with exactly one child
  double coverage = 0;    ///< Size over width times height, more than 0
  /// Active hinges over Size - 2; 0 below Size 3.
  double joints = 0;
  int hinge_count = 0;          ///< joints
  int active_hinges_count = 0;  ///< joints that carry a module
  int brick_count = 0;
  int touch_sensor_count = 0;
  int brick_sensor_count = 0;  ///< always 0; the alphabet has none
  double proportion = 0;       ///< shorter over longer side, more than 0
  int width = 0;               ///< cells, to the right; at least 1
  int height = 0;              ///< cells, to the front; at least 1
  int absolute_size = 0;  ///< the paper's Size: modules without sensors, at
                          ///< least 1; 0 is no robot
  double sensors = 0;  ///< the paper's Sensors: touch sensors over free slots
  /// Of the cells off an axis of the core, those whose mirror cell is taken,
  /// for the better of both axes; the core does not count.
  double symmetry = 0;
  /// Slots of core (4) and bricks (3) without a child but a sensor; 0.0001
  /// where there is none, as the authors have.
  double free_slots = 0;
};

/// Authors' program, measure_brain.py. Over oscillators, those of joints that
/// carry nothing included. s(x) is 1 / (1 + exp(-x)); deviations are those of
/// the population; averages are medians over 10, the largest parameter.
struct BrainDescriptors {
  double avg_period = 0;        ///< of s, 0 to 1
  double dev_period = 0;        ///< s(deviation), 0.5 to 1
  double avg_phase_offset = 0;  ///< of periods, 0 to 1
  double dev_phase_offset = 0;  ///< s(deviation), 0.5 to 1
  double avg_amplitude = 0;     ///< 0 to 1
  double dev_amplitude = 0;     ///< s(deviation), 0.5 to 1
  /// s(median of each oscillator's deviation of its three parameters), 0.5 to 1
  double avg_intra_dev_params = 0;
  /// s(mean of the three deviations), 0.5 to 1
  double avg_inter_dev_params = 0;
  /// Median over touch inputs of their edges over oscillators, 0 to 1: the
  /// paper's Sensors Reach.
  double sensors_reach = 0;
  double recurrence = 0;  ///< loops over oscillators, 0 to 1
  /// Median over oscillators of the smaller over the larger of the sums of
  /// negative and of positive weights of edges into it, 0 to 1.
  double synaptic_reception = 0;
};

BodyDescriptors DescribeBody(const Body& body);
/// All zero when no joint carries a module.
BrainDescriptors DescribeBrain(const Phenotype& phenotype);

/// A descriptor for tables and files; counts are whole numbers.
struct NamedValue {
  std::string_view name;
  double value = 0;
  bool is_count = false;
};

/// In the order of the structs above, under the same names.
std::vector<NamedValue> List(const BodyDescriptors& descriptors);
std::vector<NamedValue> List(const BrainDescriptors& descriptors);
/// The behavioural ones of sim/measures.h, all 0 where they are not valid.
std::vector<NamedValue> List(const Behaviour& behaviour);

/// The reverse, of the values of List, all of them in its order. A behaviour is
/// valid then.
BodyDescriptors BodyDescriptorsOf(const std::vector<double>& values);
BrainDescriptors BrainDescriptorsOf(const std::vector<double>& values);
Behaviour BehaviourOf(const std::vector<double>& values);

}  // namespace plsc
