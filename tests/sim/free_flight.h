#pragma once

// Options and sums for tests of moving links far from any ground.

#include <Eigen/Geometry>

#include "sim/world.h"

namespace plsc::test {

/// No gravity, no air, 100 m above the ground.
inline SimulationOptions FreeFlight(EngineKind engine) {
  SimulationOptions options;
  options.physics.engine = engine;
  options.start_height = 100;
  options.physics.gravity = 0;
  options.physics.damping = 0;
  return options;
}

/// kg m2, of a link, world frame.
inline Eigen::Matrix3d InertiaOf(const Assembly& assembly, const World& world,
                                 int link) {
  const Eigen::Matrix3d axes = world.PoseOf(link).axes;
  return axes * assembly.links[static_cast<std::size_t>(link)].inertia *
         axes.transpose();
}

/// N s, of the whole robot.
inline Eigen::Vector3d Momentum(const Assembly& assembly, const World& world) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < world.links(); ++i)
    sum += assembly.links[static_cast<std::size_t>(i)].mass *
           world.MotionOf(i).velocity;
  return sum;
}

/// N m s, of one link about a point.
inline Eigen::Vector3d AngularMomentumOf(const Assembly& assembly,
                                         const World& world, int link,
                                         const Eigen::Vector3d& about) {
  const LinkMotion motion = world.MotionOf(link);
  const Eigen::Vector3d arm = world.PoseOf(link).position - about;
  return assembly.links[static_cast<std::size_t>(link)].mass *
             arm.cross(motion.velocity) +
         InertiaOf(assembly, world, link) * motion.spin;
}

/// N m s, of the whole robot about its centre of mass.
inline Eigen::Vector3d AngularMomentum(const Assembly& assembly,
                                       const World& world) {
  const Eigen::Vector3d centre = world.MassCentre();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < world.links(); ++i)
    sum += AngularMomentumOf(assembly, world, i, centre);
  return sum;
}

/// J, of movement.
inline double KineticEnergy(const Assembly& assembly, const World& world) {
  double sum = 0;
  for (int i = 0; i < world.links(); ++i) {
    const LinkMotion motion = world.MotionOf(i);
    sum += assembly.links[static_cast<std::size_t>(i)].mass *
           motion.velocity.squaredNorm();
    sum += motion.spin.dot(InertiaOf(assembly, world, i) * motion.spin);
  }
  return sum / 2;
}

}  // namespace plsc::test
