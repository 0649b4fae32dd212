#pragma once

// One robot on its ground, moved step by step by the engine that its options
// name. Knows links and joint speeds; what the speeds should be is
// sim/controller's business. Worlds share nothing, so they may be stepped in
// several threads, but each by one thread at a time.

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "sim/assembly.h"
#include "sim/engine.h"
#include "sim/ground.h"
#include "sim/options.h"
#include "sim/placement.h"
#include "sim/terrain.h"

namespace plsc {

class World {
 public:
  /// At the origin as SimulationOptions say, all at rest.
  World(const Assembly& assembly, const Terrain& terrain,
        const SimulationOptions& options);
  /// Elsewhere, all at rest.
  World(const Assembly& assembly, const Terrain& terrain,
        const SimulationOptions& options, const Placement& placement);

  /// rad/s that the joint's motor strives for, until told otherwise.
  void SetJointSpeed(int joint, double speed);
  /// Sets a link in motion; joined links do not follow before the next step.
  void SetMotion(int link, const LinkMotion& motion);

  /// Puts a link anywhere. Joined links must be put to where they fit.
  void SetState(int link, const LinkPose& pose, const LinkMotion& motion);

  /// One PhysicsOptions::step. False if the world went wrong: failure() tells
  /// how. It must not be stepped again then.
  [[nodiscard]] bool Step();

  /// Calls `listener` at the end of each part of every step, to tell where
  /// time goes: the world itself reads no clock.
  void Listen(std::function<void(StepPart)> listener);

  using Failure = Engine::Failure;
  const Failure& failure() const;

  int joints() const;
  double Mass() const;                 ///< kg, of the whole robot
  double JointAngle(int joint) const;  ///< rad
  /// rad/s, by joint, after the latest step; `speeds` has a place for each.
  void TellJointSpeeds(std::vector<double>& speeds) const;
  /// N m, likewise: of the servos in the latest step. ODE counts what a stop
  /// gives among it, as both are one row of its solver.
  void TellJointTorques(std::vector<double>& torques) const;
  int links() const;
  LinkPose PoseOf(int link) const;
  LinkMotion MotionOf(int link) const;
  Eigen::Vector3d CorePosition() const;  ///< m, of the core's centre
  Eigen::Vector3d MassCentre() const;    ///< m, of the whole robot

  /// Contact points of the latest step, as the solver got them; 0 before.
  int contacts() const;
  /// By Body::modules: whether a box of the module met the ground or another
  /// link in the latest step. Not subject to the cap on contacts.
  const std::vector<bool>& touched() const;
  /// Steps so far in which the solver found no answer and went on with what it
  /// had. ODE ("LCP internal error"): 0 to 3 in a life of 50 s, with joint
  /// errors of a few millimetres at most.
  int solver_warnings() const;
  /// Of where all links are and how they move, bit for bit.
  std::uint64_t Hash() const;

 private:
  std::vector<Link> links_;  ///< in the rest pose
  std::unique_ptr<Engine> engine_;
};

}  // namespace plsc
