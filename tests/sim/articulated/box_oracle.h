#pragma once

// What is true of two boxes, by other ways than the engine's and in long
// double: shadows of corners on the 15 axes, and the overlap of two faces as
// all crossings of their lines that lie within both.

#include <vector>

#include "sim/articulated/box_contact.h"

namespace plsc::test {

using Real = long double;

struct Vector {
  Real x = 0, y = 0, z = 0;
};

/// A line on which the shadows of two boxes are compared.
struct ShadowAxis {
  Vector direction;  ///< unit, from the first box to the second
  Real overlap = 0;  ///< m, negative if apart
  bool is_edge = false;
};

/// Without pairs of edges whose sine is below 1e-6.
std::vector<ShadowAxis> ShadowAxes(const OrientedBox& a, const OrientedBox& b);

/// Whether an edge of each is parallel but for such a sine.
bool HaveParallelEdges(const OrientedBox& a, const OrientedBox& b);

/// From centre to centre, where boxes as turned as these begin to touch if the
/// second comes from far along `way`. Centres are not looked at.
double TouchingDistance(const OrientedBox& a, const OrientedBox& b,
                        const double (&way)[3]);

/// How far a point is outside of a box, m, along the worst side; negative
/// inside.
Real Outside(const OrientedBox& box, const double (&point)[3]);

struct DeepPoint {
  Real x = 0, y = 0;  ///< m, in the plane of the reference face
  Real depth = 0;     ///< m
};

/// The overlap of the face of a reference box along one of its sides with the
/// face of the other that looks most against it.
struct FaceOverlap {
  std::vector<DeepPoint> corners;  ///< around it, those that are deep
  /// The two faces of the other box that look most against it do so equally.
  bool is_ambiguous = false;
};
FaceOverlap OverlapOf(const OrientedBox& reference, int side, Real sign,
                      const OrientedBox& other);

/// Where a point is in the plane of such a face.
DeepPoint InPlane(const OrientedBox& reference, int side,
                  const BoxContact& contact);

/// Of the convex hull, m2.
Real HullArea(std::vector<DeepPoint> points);

}  // namespace plsc::test
