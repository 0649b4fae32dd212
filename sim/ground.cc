// Contact of boxes with the ground, by hand and not by ODE, which has no rough
// ground without a mesh and gives up to four contacts a box, rows that the
// solver pays for. A plane touches a convex body at corners only, so eight
// points a box decide; rough ground may meet a side between two corners, so
// long sides get points in between, and what is narrower than these is not
// seen.
//
// Most boxes are in the air. A sphere and a box about the link spare all of it,
// how far a box reaches down its eight corners; on hills a sphere grows by what
// the ground can rise across it (steepest). All of this only leaves out points
// that cannot touch: a rule that dropped a touching corner would be another
// physics.
//
// Spanning keeps four points: the deepest, the one farthest from it, the one
// that makes the largest triangle, and the one that lies farthest outside of
// that. This is the greedy hull that physics engines use for persistent
// contacts; a fifth point would hold a rigid link hardly better and costs three
// rows more. Of equals the first is taken, in the order of the boxes, so that
// the choice is a function of the numbers.

#include "sim/ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim/maths/sine.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

/// Twice the area of the triangle a, b, c seen against the normal; negative
/// if they run clockwise.
double Area(const Vector3d& a, const Vector3d& b, const Vector3d& c,
            const Vector3d& normal) {
  return (b - a).cross(c - a).dot(normal);
}

/// The contact of the greatest score; of equals the first, so that the choice
/// never depends on anything but the numbers.
template <typename Score>
const GroundContact& Best(const std::vector<GroundContact>& contacts,
                          const Score& score) {
  return *std::max_element(contacts.begin(), contacts.end(),
                           [&](const GroundContact& a, const GroundContact& b) {
                             return score(a) < score(b);
                           });
}

// m2. Boxes are millimetres across at least (1 mm the plate), so that real
// triangles are larger by far; what is smaller is rounding.
constexpr double kNoArea = 1e-9;

// m. More than sums of lengths below 1 m lose, less than any depth of concern:
// a corner is never passed over.
constexpr double kRoundOff = 1e-12;

// Fine points of a box at most: 3 x 3 x 3 but for its centre.
constexpr int kMostFine = 26;

/// -1, 1 and, if the side is long, 0.
std::vector<double> Places(double side) {
  if (side > kFineSide) return {-1, 0, 1};
  return {-1, 1};
}

/// Of the surface, about the box's centre.
Eigen::Matrix3Xd FinePoints(const Box& box) {
  std::vector<Vector3d> points;
  for (const double x : Places(box.size.x()))
    for (const double y : Places(box.size.y()))
      for (const double z : Places(box.size.z()))
        if (x != 0 || y != 0 || z != 0)
          points.push_back(box.axes * Vector3d(x, y, z).cwiseProduct(box.size) /
                           2);
  Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    all.col(static_cast<Eigen::Index>(i)) = points[i];
  return all;
}

}  // namespace

Vector3d GroundNormal(const Terrain& terrain) {
  if (terrain.type != TerrainType::kTilted) return Vector3d::UnitZ();
  const auto [sine, cosine] = SinCos(terrain.tilt);
  return {0, -sine, cosine};
}

LinkCorners CornersOf(const Link& link) {
  LinkCorners corners;
  const double far = std::numeric_limits<double>::infinity();
  Vector3d low = Vector3d::Constant(far), high = Vector3d::Constant(-far);
  for (const Box& box : link.boxes) {
    BoxCorners next;
    next.module = box.module;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d signs((corner & 1) != 0 ? 1 : -1,
                           (corner & 2) != 0 ? 1 : -1,
                           (corner & 4) != 0 ? 1 : -1);
      next.points.col(corner) = box.centre - link.centre +
                                box.axes * signs.cwiseProduct(box.size) / 2;
      corners.radius = std::max(corners.radius, next.points.col(corner).norm());
    }
    next.centre = box.centre - link.centre;
    next.half = box.axes.cwiseAbs() * box.size / 2;
    next.radius = box.size.norm() / 2;
    next.fine = FinePoints(box).colwise() + next.centre;
    corners.boxes.push_back(next);
    low = low.cwiseMin(next.centre - next.half);
    high = high.cwiseMax(next.centre + next.half);
  }
  corners.centre = (low + high) / 2;
  corners.half = (high - low) / 2;
  return corners;
}

void AppendGroundContacts(const LinkCorners& link, const LinkPose& pose,
                          const Vector3d& normal,
                          std::vector<GroundContact>& contacts) {
  const double height = normal.dot(pose.position);
  if (height > link.radius) return;
  // The normal is turned into the link's frame once, not every corner out.
  const Vector3d up = pose.axes.transpose() * normal;
  const Vector3d reach = up.cwiseAbs();
  if (height + up.dot(link.centre) > reach.dot(link.half) + kRoundOff) return;
  int key = -8;
  for (const BoxCorners& box : link.boxes) {
    key += 8;
    // Most boxes of most robots are in the air: one test spares eight.
    if (height + up.dot(box.centre) > reach.dot(box.half) + kRoundOff) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d point = box.points.col(corner);
      const double depth = -(height + up.dot(point));
      if (depth < 0) continue;
      contacts.push_back({box.module, depth, pose.position + pose.axes * point,
                          normal, key + corner});
    }
  }
}

void AppendRoughContacts(const LinkCorners& link, const LinkPose& pose,
                         const HeightField& field,
                         std::vector<GroundContact>& contacts) {
  if (pose.position.z() - link.radius > field.bound()) return;
  int key = -kMostFine;
  for (const BoxCorners& box : link.boxes) {
    key += kMostFine;
    const Vector3d centre = pose.position + pose.axes * box.centre;
    // The ground under any point of the box is at most so much higher than
    // under its centre.
    const double rise = field.steepest() * box.radius;
    if (centre.z() - box.radius - rise >
        field.At(centre.x(), centre.y()).height)
      continue;
    for (Eigen::Index i = 0; i < box.fine.cols(); ++i) {
      const Vector3d point = pose.position + pose.axes * box.fine.col(i);
      const HeightField::Point ground = field.At(point.x(), point.y());
      const double below = ground.height - point.z();
      if (below < 0) continue;
      const Vector3d normal =
          Vector3d(-ground.slope_x, -ground.slope_y, 1).normalized();
      contacts.push_back({box.module, below * normal.z(), point, normal,
                          key + static_cast<int>(i)});
    }
  }
}

FewContacts Spanning(const std::vector<GroundContact>& contacts,
                     const Vector3d& normal) {
  FewContacts few;
  if (contacts.size() <= few.contacts.size()) {
    for (const GroundContact& contact : contacts) few.Add(contact);
    return few;
  }
  const GroundContact& first =
      Best(contacts, [](const GroundContact& c) { return c.depth; });
  const Vector3d& a = first.position;
  const GroundContact& second = Best(contacts, [&](const GroundContact& c) {
    return (c.position - a).squaredNorm();
  });
  const Vector3d& b = second.position;
  const GroundContact& third = Best(contacts, [&](const GroundContact& c) {
    return std::abs(Area(a, b, c.position, normal));
  });
  const Vector3d& c = third.position;
  const double area = Area(a, b, c, normal);
  few.Add(first);
  few.Add(second);
  if (std::abs(area) < kNoArea) return few;
  few.Add(third);
  // How far a point lies outside of the triangle, as the area it would add.
  const double side = area > 0 ? 1 : -1;
  const auto added = [&](const GroundContact& d) {
    const Vector3d& p = d.position;
    return -std::min({side * Area(a, b, p, normal),
                      side * Area(b, c, p, normal),
                      side * Area(c, a, p, normal)});
  };
  const GroundContact& fourth = Best(contacts, added);
  if (added(fourth) >= kNoArea) few.Add(fourth);
  return few;
}

}  // namespace plsc
