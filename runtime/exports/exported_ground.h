#pragma once

// The ground of a season as far as a file can hold it: what rises from the
// plane, around the place where the robot starts. The plane itself, level or
// tilted, has no end in any format.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/static_boxes.h"
#include "sim/terrain.h"

namespace plsc {

struct ExportedGround {
  /// m; relief is there for x and y from -reach to +reach. 0: it has no end.
  double reach = 0;
  /// m, on a square grid from -reach to +reach, columns along x, rows along y;
  /// empty unless the ground is rough.
  Eigen::MatrixXd heights;
  /// Steps (all of them) or obstacles, which stand in the plane.
  std::vector<StaticBox> boxes;

  double lowest() const;  ///< m; 0 without heights
  double highest() const;
};

ExportedGround GroundOf(const Terrain& terrain);

/// "flat ground", "ground that is {tilted: 5 deg}", as scenarios say it.
std::string GroundText(const Terrain& terrain);

}  // namespace plsc
