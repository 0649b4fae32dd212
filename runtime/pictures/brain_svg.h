#pragma once

// The brains of one genotype in several environments as one picture: sensors,
// their inputs, the oscillators, the joints that these drive, from left to
// right. In each column the nodes are in the order of their modules.

#include <string>
#include <vector>

#include "sim/phenotype.h"

namespace plsc {

struct DrawnBrain {
  std::string name;    ///< of the environment
  std::string senses;  ///< what is sensed there; may be empty
  Phenotype phenotype;
};

/// A complete SVG file. An edge's width is its weight's size, its colour and
/// dashes are its sign. What is not as in the first brain is marked: black
/// under edges and around nodes, dashed where only numbers differ, and below
/// the brain in words what only the first one has.
std::string BrainsSvg(const std::string& title,
                      const std::vector<DrawnBrain>& brains);

}  // namespace plsc
