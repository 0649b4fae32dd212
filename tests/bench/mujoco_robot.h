#pragma once

// The same robot in MuJoCo (2.2), to compare speeds with: links, boxes,
// masses, inertias, hinges, stops and servo of an Assembly, as MJCF. A peer in
// a benchmark, never a part of plsc; its soft contacts creep, so displacements
// are another matter.

#include <memory>
#include <string>

#include "sim/assembly.h"
#include "sim/options.h"
#include "sim/placement.h"
#include "sim/terrain.h"

namespace plsc::bench {

/// Newton solver, pyramidal cone, semi-implicit Euler, the same step. Servos
/// are velocity servos whose gain is their greatest torque per 1 rad/s, so
/// that it is never passed; their damping is implicit, as Euler has it there.
std::string MjcfOf(const Assembly& assembly, const Terrain& terrain,
                   const SimulationOptions& options,
                   const Placement& placement);

class MujocoRobot {
 public:
  explicit MujocoRobot(const std::string& mjcf);
  ~MujocoRobot();
  MujocoRobot(const MujocoRobot&) = delete;
  MujocoRobot& operator=(const MujocoRobot&) = delete;

  int joints() const;
  void SetJointSpeed(int joint, double speed);  ///< rad/s
  double JointAngle(int joint) const;           ///< rad
  void Step();
  int contacts() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace plsc::bench
