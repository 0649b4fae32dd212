#pragma once

// Morphological and controller descriptors, under the authors' names and by
// their formulas (paper, "Robot Descriptors"; docs/development.md), so that
// results compare with theirs.

#include <string_view>
#include <vector>

#include "sim/measures.h"
#include "sim/phenotype.h"

namespace plsc {

struct BodyDescriptors {
  double branching = 0;
  int branching_modules_count = 0;
  double limbs = 0;
  int extremities = 0;
  double length_of_limbs = 0;
  int extensiveness = 0;
  double coverage = 0;
  double joints = 0;
  int hinge_count = 0;
  int active_hinges_count = 0;  ///< joints that carry a module
  int brick_count = 0;
  int touch_sensor_count = 0;
  int brick_sensor_count = 0;  ///< always 0; the alphabet has none
  double proportion = 0;
  int width = 0;          ///< cells
  int height = 0;         ///< cells
  int absolute_size = 0;  ///< the paper's Size: modules without sensors
  double sensors = 0;
  double symmetry = 0;
  double free_slots = 0;  ///< 0.0001 where there is none, as the authors have
};

struct BrainDescriptors {
  double avg_period = 0;
  double dev_period = 0;
  double avg_phase_offset = 0;
  double dev_phase_offset = 0;
  double avg_amplitude = 0;
  double dev_amplitude = 0;
  double avg_intra_dev_params = 0;
  double avg_inter_dev_params = 0;
  double sensors_reach = 0;
  double recurrence = 0;
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

}  // namespace plsc
