#pragma once

// What two faces have in common: a polygon in the plane of one of them, cut out
// of the other, and the few corners of it that hold as well as all.

#include <array>
#include <cstddef>

namespace plsc {

// m. More than sums of lengths below 1 m lose, less than any depth of concern.
inline constexpr double kBoxRounding = 1e-12;

/// Corners that are kept: they span the support but for slivers.
inline constexpr std::size_t kMostSupport = 4;

/// A corner of the cut face, in the axes of the face that it lies on.
struct FacePoint {
  double place[2];  ///< m, from the middle of the face
  double depth;     ///< m
  /// What it is: 0 to 3 a corner of the cut face; 4 + 4 e + s where its edge e
  /// crosses side s; 20 to 23 a corner of the cutting face.
  int feature;
  int edge;  ///< what leads to the next point: 0 to 3, or 4 + side
};

/// A cut of a convex polygon makes one corner more, of four corners eight. If
/// rounding bends an edge, so that a line leaves and enters n corners n/2
/// times, it is at most 4, 6, 9, 13, 19.
struct FacePolygon {
  std::array<FacePoint, 20> points;  // not initialised, as few are used
  std::size_t count;

  void Add(const FacePoint& point) { points[count++] = point; }
};

/// A side of the cutting face. Sides 0 and 1 are the high and the low one of
/// the first coordinate, 2 and 3 of the second.
struct CuttingSide {
  int number;
  double half;  ///< m

  double sign() const { return number % 2 == 0 ? 1 : -1; }
};

/// Makes `rest` of what lies within the side; false, and nothing, if that is
/// all.
bool Cut(const FacePolygon& polygon, const CuttingSide& side,
         FacePolygon& rest);

/// Puts the points first that are handed on, the deepest before all; how many
/// these are, at most kMostSupport. There must be one at least.
std::size_t KeepSupport(FacePolygon& polygon);

}  // namespace plsc
