#include "tests/sim/ground_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plsc::test {
namespace {

double DepthAt(const HeightField& field, const double (&point)[3]) {
  const HeightField::Point ground = field.At(point[0], point[1]);
  return (ground.height - point[2]) /
         std::sqrt(1 + ground.slope_x * ground.slope_x +
                   ground.slope_y * ground.slope_y);
}

}  // namespace

double DeepestSample(const OrientedBox& box, const HeightField& field,
                     int per_side) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (int side = 0; side < 3; ++side)
    for (const int sign : {-1, 1})
      for (int i = 0; i < per_side; ++i)
        for (int j = 0; j < per_side; ++j) {
          double part[3];
          part[side] = sign;
          part[(side + 1) % 3] = 2.0 * i / (per_side - 1) - 1;
          part[(side + 2) % 3] = 2.0 * j / (per_side - 1) - 1;
          double point[3];
          for (int k = 0; k < 3; ++k) {
            point[k] = box.centre[k];
            for (int axis = 0; axis < 3; ++axis)
              point[k] += part[axis] * box.half[axis] * box.axes[axis][k];
          }
          deepest = std::max(deepest, DepthAt(field, point));
        }
  return deepest;
}

double NearestSurface(const HeightField& field, const double (&point)[3]) {
  // The nearest point (u, v, h) is where the way to it is along the normal:
  // u = x - (h - z) dh/du. A depth far below the radius of a hill makes the
  // iteration contract.
  double u = point[0], v = point[1];
  for (int i = 0; i < 100; ++i) {
    const HeightField::Point ground = field.At(u, v);
    const double below = ground.height - point[2];
    u = point[0] - below * ground.slope_x;
    v = point[1] - below * ground.slope_y;
  }
  const double height = field.At(u, v).height;
  return std::sqrt((u - point[0]) * (u - point[0]) +
                   (v - point[1]) * (v - point[1]) +
                   (height - point[2]) * (height - point[2]));
}

}  // namespace plsc::test
