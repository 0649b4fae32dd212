#pragma once

// Where the nodes of a brain go in a picture: inputs in one column, the
// oscillators in the next, each in the order of their modules, so that the same
// brain always looks the same. Edges lead from inputs to oscillators, or back
// to their node, so two layers are all there are.

#include <vector>

#include "sim/brain.h"

namespace plsc {

// px. The middles of the columns: touch sensors, inputs, oscillators, joints.
inline constexpr int kSensorColumn = 0;
inline constexpr int kInputColumn = 75;
inline constexpr int kOscillatorColumn = 330;
inline constexpr int kJointColumn = 410;
inline constexpr int kRowHeight = 64;  ///< px
inline constexpr int kLoopRowHeight =
    96;  ///< px; a loop fits between two nodes

struct NodePlace {
  int x = 0;
  int y = 0;         ///< px, from the first row's middle
  double share = 0;  ///< 0 the first of its column, 1 the last
};

struct BrainLayout {
  std::vector<NodePlace> places;  ///< by node
  int height = 0;                 ///< px, of the rows
};

/// The shorter column stands in the middle of the longer one's height.
BrainLayout LayOutBrain(const Brain& brain, int row_height);

}  // namespace plsc
