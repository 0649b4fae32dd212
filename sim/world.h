#pragma once

// One robot on its ground, moved step by step: the only door to ODE. Knows
// links and joint speeds; what the speeds should be is sim/controller's
// business. Worlds share nothing, so they may be stepped in several threads,
// but each by one thread at a time.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/assembly.h"
#include "sim/ground.h"
#include "sim/options.h"
#include "sim/terrain.h"

namespace plsc {

// A link beyond these is a solver gone wrong, not a robot. 50 m/s is more than
// 50 s of sliding down 5 degrees without friction (42 m/s); joints turn at
// 1 rad/s and falls are from decimetres. 500 rad/s moves a point 0.1 m away
// as fast.
inline constexpr double kMaxSpeed = 50;  ///< m/s
inline constexpr double kMaxSpin = 500;  ///< rad/s

struct LinkMotion {
  Eigen::Vector3d velocity;  ///< m/s, of the centre of mass
  Eigen::Vector3d spin;      ///< rad/s, world frame
};

class World {
 public:
  /// The core's centre at (0, 0, start_height), unrotated, all at rest.
  World(const Assembly& assembly, const Terrain& terrain,
        const SimulationOptions& options);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// rad/s that the joint's motor strives for, until told otherwise.
  void SetJointSpeed(int joint, double speed);
  /// Sets a link in motion; joined links do not follow before the next step.
  void SetMotion(int link, const LinkMotion& motion);

  /// One PhysicsOptions::step. False if the state is lost: not finite, or
  /// beyond kMaxSpeed or kMaxSpin. A lost world must not be stepped again.
  [[nodiscard]] bool Step();

  int joints() const;
  double JointAngle(int joint) const;  ///< rad
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
  /// Warnings of the solver so far ("LCP internal error"): 0 to 3 in a life
  /// of 50 s, with joint errors of a few millimetres at most.
  int solver_warnings() const;
  /// Of positions, quaternions and velocities of all links, bit for bit.
  std::uint64_t Hash() const;

 private:
  struct Ode;
  std::unique_ptr<Ode> ode_;
};

}  // namespace plsc
