// A robot is put down by measuring how far its lowest point is above the ground
// and lowering it by that: the gap is taken along the vertical, in which it
// shrinks exactly as the robot is lowered, on planes of any tilt and on hills.
// On boxes the whole column under a part counts, so that a robot starts on top
// of a step and never inside. The points are those that contacts are made of
// (sim/ground): a robot that was placed by others would begin in the ground.

#include "sim/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/ground.h"
#include "sim/height_field.h"
#include "sim/maths/arc.h"
#include "sim/maths/sine.h"
#include "sim/static_boxes.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double GapToPlane(const Eigen::Matrix3Xd& points, const Vector3d& normal) {
  return (normal.transpose() * points).minCoeff() / normal.z();
}

double GapToField(const Eigen::Matrix3Xd& points, const HeightField& field) {
  double gap = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    gap = std::min(gap,
                   points(2, i) - field.At(points(0, i), points(1, i)).height);
  return gap;
}

/// Of the plane or the hills; steps and obstacles stand on it.
double HeightAt(const Terrain& terrain, const Spot& spot) {
  if (terrain.type == TerrainType::kRough)
    return HeightField(terrain.rough).At(spot.x, spot.y).height;
  const Vector3d normal = GroundNormal(terrain);
  return -(normal.x() * spot.x + normal.y() * spot.y) / normal.z();
}

/// To the boxes anywhere under or above the part.
double GapToBoxes(const Eigen::Matrix3Xd& points, const Terrain& terrain) {
  const Vector3d low = points.rowwise().minCoeff();
  const Vector3d high = points.rowwise().maxCoeff();
  const Eigen::AlignedBox3d column(
      Vector3d(low.x(), low.y(), std::min(low.z(), -kBoxDepth)),
      Vector3d(high.x(), high.y(), std::max(high.z(), 0.0)));
  std::vector<StaticBox> boxes;
  AppendStaticBoxes(terrain, column, boxes);
  double gap = std::numeric_limits<double>::infinity();
  for (const StaticBox& box : boxes)
    gap = std::min(gap, low.z() - (box.centre.z() + box.size.z() / 2));
  return gap;
}

}  // namespace

Spot Displaced(const Spot& spot, const Disturbance& disturbance) {
  // Adding zeros would make 0 of -0, which are other bits.
  Spot place = spot;
  if (disturbance.shift_x != 0) place.x += disturbance.shift_x;
  if (disturbance.shift_y != 0) place.y += disturbance.shift_y;
  if (disturbance.yaw != 0) place.heading += disturbance.yaw;
  return place;
}

Matrix3d Heading(double angle) {
  const auto [sine, cosine] = SinCos(angle);
  Matrix3d axes;
  axes << cosine, -sine, 0,  //
      sine, cosine, 0,       //
      0, 0, 1;
  return axes;
}

Matrix3d AlignedAxes(const Terrain& terrain) {
  if (terrain.type != TerrainType::kTilted) return Matrix3d::Identity();
  const auto [sine, cosine] = SinCos(terrain.tilt);
  Matrix3d axes;
  axes << 1, 0, 0,       //
      0, cosine, -sine,  //
      0, sine, cosine;
  return axes;
}

double Gap(const Assembly& assembly, const Placement& placement,
           const Terrain& terrain) {
  const Vector3d normal = GroundNormal(terrain);
  const HeightField field(terrain.rough);
  double gap = std::numeric_limits<double>::infinity();
  for (const Link& link : assembly.links) {
    const Vector3d centre = placement(link.centre);
    for (const BoxCorners& box : CornersOf(link).boxes) {
      const bool is_rough = terrain.type == TerrainType::kRough;
      Eigen::Matrix3Xd local = box.points;
      if (is_rough) local = box.fine;
      const Eigen::Matrix3Xd points =
          (placement.axes * local).colwise() + centre;
      gap = std::min(gap, is_rough ? GapToField(points, field)
                                   : GapToPlane(points, normal));
      gap = std::min(gap, GapToBoxes(points, terrain));
    }
  }
  return gap;
}

Placement SetDown(const Assembly& assembly, const Matrix3d& axes,
                  const Spot& spot, const Terrain& terrain, double clearance) {
  Placement placement{{spot.x, spot.y, 0}, axes};
  // The gap is along the vertical, so it shrinks as much as one is lowered.
  placement.position.z() = clearance - Gap(assembly, placement, terrain);
  return placement;
}

Placement StartOf(const Assembly& assembly, const Terrain& terrain,
                  const SimulationOptions& options, const Spot& spot) {
  if (options.start_height)
    return {{spot.x, spot.y, HeightAt(terrain, spot) + *options.start_height},
            Heading(spot.heading)};
  return SetDown(assembly, AlignedAxes(terrain) * Heading(spot.heading), spot,
                 terrain, options.start_clearance);
}

Spot SpotOf(const Placement& core) {
  const Vector3d front = core.axes.col(1);
  const Vector3d right = core.axes.col(0);
  Spot spot{core.position.x(), core.position.y(), 0};
  // On end: the front points up or down and tells nothing.
  constexpr double kOnEnd = 1e-6;
  spot.heading = front.head<2>().norm() > kOnEnd ? Atan2(-front.x(), front.y())
                                                 : Atan2(right.y(), right.x());
  return spot;
}

}  // namespace plsc
