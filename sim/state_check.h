#pragma once

// When a state is no robot's: numbers that are not finite, links faster than
// any servo or slope makes them, links below the ground, a solver that failed
// too often. Held against every state that a step leaves, as a robot that
// explodes may do so for many steps before a number overflows, and would be
// fast until then.

#include <vector>

#include "sim/engine.h"

namespace plsc {

class StateCheck {
 public:
  explicit StateCheck(const Scene& scene);

  /// What is wrong with the link, if so; an outcome of kCompleted is nothing.
  Engine::Failure Look(int link, const Eigen::Vector3d& position,
                       const LinkMotion& motion) const;
  /// Whether nothing is, if `height` (m) is the link's above the ground's
  /// plane: the same question, asked quickly.
  bool IsFine(int link, double height, const LinkMotion& motion) const {
    // What is no number is not below anything.
    return motion.velocity.squaredNorm() <= speed_squared_ &&
           motion.spin.squaredNorm() <= spin_squared_ &&
           height >= -deepest_[static_cast<std::size_t>(link)];
  }
  /// Likewise of the solver, which failed in so many steps.
  Engine::Failure LookAtSolver(int warnings) const;

 private:
  PhysicsOptions physics_;
  Eigen::Vector3d normal_;       ///< of the ground
  std::vector<double> deepest_;  ///< m, by link: its centre, below the ground
  double speed_squared_, spin_squared_;  ///< a little less than the limits'
  double most_warnings_ = 0;
};

}  // namespace plsc
