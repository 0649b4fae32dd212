#pragma once

// A part of the ground on a square of a picture, north (+y) up: where a point
// comes to lie, and what of the ground is drawn below a path.

#include <Eigen/Core>
#include <string>

#include "sim/terrain.h"

namespace plsc {

struct MapView {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m, shown in the middle
  double scale = 1000;                               ///< px per m
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< px, top left
  double side = 380;                                 ///< px

  /// px, y down.
  Eigen::Vector2d operator()(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d shift = (point - centre) * scale;
    return {corner.x() + side / 2 + shift.x(),
            corner.y() + side / 2 - shift.y()};
  }
};

/// Elements that show what rises from the plane, as far as the view goes:
/// obstacles and steps as boxes, rough ground as shades (darker is lower).
/// Nothing where they would be smaller than a few pixels.
std::string GroundSvg(const Terrain& terrain, const MapView& view);

/// m, of 1, 2 or 5 times a power of ten: the longest of at most `pixels`.
double RoundLength(double pixels, double scale);

}  // namespace plsc
