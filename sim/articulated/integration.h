#pragma once

// From the step's speeds to the next state.

#include <vector>

#include "sim/articulated/momenta.h"
#include "sim/options.h"

namespace plsc::articulated {

/// Velocities and spins of all links, at the pose that the state has: the
/// baseline's and what the base and joints do beyond it. `excess`, rad/s, by
/// link.
void SetSpeeds(const Model& model, const std::vector<LinkMomenta>& momenta,
               const Spatial& base, const std::vector<double>* excess,
               State& state);

/// Moves everything by a step at these speeds, joints at `targets` and what
/// `excess` adds (rad/s by link; null: nothing). Gives how far any joint
/// turned, rad.
double Move(const Model& model, const std::vector<double>& targets,
            const std::vector<double>* excess, double step, State& state);

/// Takes the share `damping` of all speeds that are above ODE's thresholds.
void Damp(double damping, State& state);

}  // namespace plsc::articulated
