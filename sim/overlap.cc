// Two boxes are apart if and only if some plane separates them, and of all
// planes the fifteen need to be tried that are parallel to a face of either or
// to an edge of each (Gottschalk, Lin and Manocha 1996). On each normal the
// boxes are shadows: an interval about the centre, half as long as Reach. Links
// times boxes squared; a robot has some tens of boxes, and is tested once, so
// there is no tree and no grid.
//
// The tolerance is on the side of "apart": boxes that only touch must not be
// refused for the last bit of a rounded sum.

#include "sim/overlap.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace plsc {
namespace {

using Eigen::Vector3d;

/// Half the length of the box's shadow on a unit direction.
double Reach(const Box& box, const Vector3d& direction) {
  return (box.axes.transpose() * direction).cwiseAbs().dot(box.size) / 2;
}

bool IsSeparating(const Box& a, const Box& b, const Vector3d& direction) {
  const double distance = std::abs(direction.dot(b.centre - a.centre));
  return distance >
         Reach(a, direction) + Reach(b, direction) - kOverlapTolerance;
}

}  // namespace

bool BoxesOverlap(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    if (IsSeparating(a, b, a.axes.col(i))) return false;
    if (IsSeparating(a, b, b.axes.col(i))) return false;
  }
  // Edges closer than a microradian to parallel: the face normals have already
  // told all there is to tell, and the product would be noise.
  constexpr double kParallel = 1e-6;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3d product = a.axes.col(i).cross(b.axes.col(j));
      const double length = product.norm();
      if (length > kParallel && IsSeparating(a, b, product / length))
        return false;
    }
  }
  return true;
}

std::vector<LinkPair> CollidingPairs(const Assembly& assembly) {
  std::set<std::pair<int, int>> joined;
  for (const Hinge& hinge : assembly.hinges)
    joined.insert({hinge.parent, hinge.child});  // parents come first
  std::vector<LinkPair> pairs;
  const int links = static_cast<int>(assembly.links.size());
  for (int a = 0; a < links; ++a)
    for (int b = a + 1; b < links; ++b)
      if (joined.count({a, b}) == 0) pairs.push_back({a, b});
  return pairs;
}

std::vector<Overlap> FindOverlaps(const Assembly& assembly) {
  std::vector<Overlap> overlaps;
  for (const LinkPair& pair : CollidingPairs(assembly)) {
    const auto& a = assembly.links[static_cast<std::size_t>(pair.a)].boxes;
    const auto& b = assembly.links[static_cast<std::size_t>(pair.b)].boxes;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j)
        if (BoxesOverlap(a[i], b[j]))
          overlaps.push_back(
              {pair.a, static_cast<int>(i), pair.b, static_cast<int>(j)});
  }
  return overlaps;
}

}  // namespace plsc
