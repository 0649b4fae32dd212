#pragma once

// A developed controller: the paper's hybrid network of sensor inputs and
// oscillator neurons. What the turtle of late development builds and what
// sim/controller runs.

#include <cstdint>
#include <vector>

namespace plsc {

enum class NodeType : std::uint8_t { kInput, kOscillator };

/// One a touch sensor (input) and one a joint (oscillator).
struct Node {
  NodeType type = NodeType::kInput;
  int module = 0;     ///< index into Body::modules
  double weight = 0;  ///< the symbol's own w, -1 to 1
  // Oscillators only (Eq. 1 of the paper), each 1 to 10:
  double amplitude = 0;
  double period = 0;        ///< s
  double phase_offset = 0;  ///< in periods; only its fraction acts

  friend bool operator==(const Node&, const Node&) = default;
};

/// Directed edge; source == destination is a recurrent edge (loop). Otherwise
/// the source is an input and the destination an oscillator.
struct Connection {
  int source = 0;       ///< index into Brain::nodes
  int destination = 0;  ///< index into Brain::nodes
  double weight = 0;    ///< -1 to 1

  friend bool operator==(const Connection&, const Connection&) = default;
};

/// Both in order of creation; node i is the "node(i+1)" of files.
struct Brain {
  std::vector<Node> nodes;
  std::vector<Connection> connections;

  friend bool operator==(const Brain&, const Brain&) = default;
};

/// Inputs for the six channels of the core's IMU (linear acceleration x y z,
/// angular velocity x y z). They exist in every robot, are never connected,
/// and are not listed in Brain::nodes (authors' program, plasticoding.py:663).
inline constexpr int kImuInputs = 6;

}  // namespace plsc
