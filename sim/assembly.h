#pragma once

// A Body put together in space: rigid links of boxes, joined by hinges, all
// joints at 0. What sim/overlap judges and sim/world simulates. Everything that
// no hinge separates is one link, since solving for fixed joints would cost
// four to nine times the time. World frame, the core's centre at the origin;
// link frames are unrotated, at the centre of mass.

#include <Eigen/Core>
#include <vector>

#include "sim/body.h"
#include "sim/modules.h"

namespace plsc {

struct Box {
  int module = 0;  ///< index into Body::modules
  Part part = Part::kCore;
  double mass = 0;         ///< kg
  Eigen::Vector3d size;    ///< m, full lengths of the sides
  Eigen::Vector3d centre;  ///< m
  Eigen::Matrix3d axes;    ///< columns: directions of the sides, unit
};

/// A rigid part of the robot.
struct Link {
  double mass = 0;          ///< kg, positive
  Eigen::Vector3d centre;   ///< m, of mass
  Eigen::Matrix3d inertia;  ///< kg m2, about the centre of mass
  std::vector<Box> boxes;   ///< in order of modules
};

/// The hinge of one joint module. A positive angle turns the child link
/// counter-clockwise about the axis.
struct Hinge {
  int module = 0;          ///< index into Body::modules
  int parent = 0;          ///< index into Assembly::links
  int child = 0;           ///< index into Assembly::links
  Eigen::Vector3d anchor;  ///< m
  Eigen::Vector3d axis;    ///< unit
};

/// Hinges in the order of Body::modules; hinge i moves link i + 1. Link 0
/// holds the core, as its first box.
struct Assembly {
  std::vector<Link> links;
  std::vector<Hinge> hinges;
};

/// The body must hold at least the core.
Assembly Assemble(const Body& body);

/// Of the body: one more than the highest index that a box has.
int ModulesOf(const Assembly& assembly);

double TotalMass(const Assembly& assembly);  ///< kg

}  // namespace plsc
