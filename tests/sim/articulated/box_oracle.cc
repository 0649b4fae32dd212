#include "tests/sim/articulated/box_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plsc::test {
namespace {

// m. What points and lines may differ by.
constexpr Real kSame = 1e-11L;

Vector Of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Vector operator*(Real s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}

Vector operator-(const Vector& a, const Vector& b) {
  return a + (-1 * b);
}

Real Dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Half the length of the shadow on a line.
Real ShadowOf(const OrientedBox& box, const Vector& line) {
  Real farthest = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Real at = 0;
    for (unsigned i = 0; i < 3; ++i)
      at += (corner >> i & 1U ? 1 : -1) * box.half[i] *
            Dot(line, Of(box.axes[i]));
    farthest = std::max(farthest, at);
  }
  return farthest;
}

/// Unit directions, not yet from a to b.
std::vector<ShadowAxis> Lines(const OrientedBox& a, const OrientedBox& b) {
  std::vector<ShadowAxis> lines;
  for (const OrientedBox* box : {&a, &b})
    for (const double(&axis)[3] : box->axes)
      lines.push_back({Of(axis), 0, false});
  for (const double(&u)[3] : a.axes)
    for (const double(&v)[3] : b.axes) {
      const Vector across = Cross(Of(u), Of(v));
      const Real sine = std::sqrt(Dot(across, across));
      if (sine >= 1e-6L) lines.push_back({1 / sine * across, 0, true});
    }
  for (ShadowAxis& line : lines)
    line.overlap = ShadowOf(a, line.direction) + ShadowOf(b, line.direction);
  return lines;
}

/// A line x nx + y ny = limit; inside is less.
struct HalfPlane {
  Real nx, ny, limit;
  Real Beyond(Real x, Real y) const { return x * nx + y * ny - limit; }
};

/// Corners of what all half planes have in common.
std::vector<DeepPoint> CornersOf(const std::array<HalfPlane, 8>& planes) {
  std::vector<DeepPoint> corners;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const HalfPlane &p = planes[i], &q = planes[j];
      const Real determinant = p.nx * q.ny - p.ny * q.nx;
      if (std::abs(determinant) < 1e-9L) continue;
      const Real x = (p.limit * q.ny - q.limit * p.ny) / determinant;
      const Real y = (p.nx * q.limit - q.nx * p.limit) / determinant;
      const auto is_same = [&](const DeepPoint& other) {
        return std::hypot(other.x - x, other.y - y) < kSame;
      };
      if (std::all_of(planes.begin(), planes.end(),
                      [&](const HalfPlane& plane) {
                        return plane.Beyond(x, y) < kSame;
                      }) &&
          std::none_of(corners.begin(), corners.end(), is_same))
        corners.push_back({x, y, 0});
    }
  return corners;
}

void SortAround(std::vector<DeepPoint>& points) {
  Real x = 0, y = 0;
  for (const DeepPoint& point : points) {
    x += point.x / static_cast<Real>(points.size());
    y += point.y / static_cast<Real>(points.size());
  }
  std::sort(points.begin(), points.end(),
            [&](const DeepPoint& p, const DeepPoint& q) {
              return std::atan2(p.y - y, p.x - x) <
                     std::atan2(q.y - y, q.x - x);
            });
}

}  // namespace

std::vector<ShadowAxis> ShadowAxes(const OrientedBox& a, const OrientedBox& b) {
  std::vector<ShadowAxis> axes = Lines(a, b);
  const Vector apart = Of(b.centre) - Of(a.centre);
  for (ShadowAxis& axis : axes) {
    const Real ahead = Dot(apart, axis.direction);
    if (ahead < 0) axis.direction = -1 * axis.direction;
    axis.overlap -= std::abs(ahead);
  }
  return axes;
}

bool HaveParallelEdges(const OrientedBox& a, const OrientedBox& b) {
  return Lines(a, b).size() < 15;
}

double TouchingDistance(const OrientedBox& a, const OrientedBox& b,
                        const double (&way)[3]) {
  // The way leaves the difference of the boxes, a polyhedron with these
  // normals, at the first of its faces.
  Real nearest = std::numeric_limits<Real>::infinity();
  for (const ShadowAxis& line : Lines(a, b)) {
    const Real ahead = std::abs(Dot(line.direction, Of(way)));
    if (ahead > 1e-9L) nearest = std::min(nearest, line.overlap / ahead);
  }
  return static_cast<double>(nearest);
}

Real Outside(const OrientedBox& box, const double (&point)[3]) {
  Real worst = -std::numeric_limits<Real>::infinity();
  for (int i = 0; i < 3; ++i)
    worst = std::max(
        worst, std::abs(Dot(Of(point) - Of(box.centre), Of(box.axes[i]))) -
                   box.half[i]);
  return worst;
}

FaceOverlap OverlapOf(const OrientedBox& reference, int side, Real sign,
                      const OrientedBox& other) {
  const Vector outward = sign * Of(reference.axes[side]);
  const Vector u = Of(reference.axes[(side + 1) % 3]);
  const Vector v = Of(reference.axes[(side + 2) % 3]);
  FaceOverlap overlap;
  int facing = 0;
  const auto turned = [&](int j) {
    return std::abs(Dot(outward, Of(other.axes[j])));
  };
  for (int j = 1; j < 3; ++j)
    if (turned(j) > turned(facing)) facing = j;
  for (int j = 0; j < 3; ++j)
    if (j != facing && turned(j) > turned(facing) - 1e-12L)
      overlap.is_ambiguous = true;
  const Real against = Dot(outward, Of(other.axes[facing])) > 0 ? -1 : 1;
  const Vector normal = against * Of(other.axes[facing]);
  const Vector middle =
      Of(other.centre) + other.half[facing] * normal - Of(reference.centre);
  std::array<HalfPlane, 8> planes = {{
      {1, 0, reference.half[(side + 1) % 3]},
      {-1, 0, reference.half[(side + 1) % 3]},
      {0, 1, reference.half[(side + 2) % 3]},
      {0, -1, reference.half[(side + 2) % 3]},
  }};
  std::size_t next = 4;
  for (const int turn : {1, 2}) {
    const int rim = (facing + turn) % 3, along = (facing + 3 - turn) % 3;
    // The rim's two edges run along the other side; across them in the plane:
    const Vector edge = Of(other.axes[along]);
    Real nx = Dot(edge, v), ny = -Dot(edge, u);
    const Real length = std::hypot(nx, ny);
    nx /= length;
    ny /= length;
    const auto across = [&](const Vector& p) {
      return Dot(p, u) * nx + Dot(p, v) * ny;
    };
    const Real half = std::abs(across(other.half[rim] * Of(other.axes[rim])));
    planes.at(next++) = {nx, ny, across(middle) + half};
    planes.at(next++) = {-nx, -ny, half - across(middle)};
  }
  for (DeepPoint corner : CornersOf(planes)) {
    // The point of the face above it: normal . (p - middle) = 0.
    const Vector flat = corner.x * u + corner.y * v;
    const Real height = Dot(normal, middle - flat) / Dot(normal, outward);
    corner.depth = reference.half[side] - height;
    if (corner.depth > -kSame) overlap.corners.push_back(corner);
  }
  SortAround(overlap.corners);
  return overlap;
}

DeepPoint InPlane(const OrientedBox& reference, int side,
                  const BoxContact& contact) {
  const Vector from = Of(contact.position) - Of(reference.centre);
  return {Dot(from, Of(reference.axes[(side + 1) % 3])),
          Dot(from, Of(reference.axes[(side + 2) % 3])), contact.depth};
}

Real HullArea(std::vector<DeepPoint> points) {
  SortAround(points);
  Real area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DeepPoint& p = points[i];
    const DeepPoint& q = points[(i + 1) % points.size()];
    area += (p.x * q.y - p.y * q.x) / 2;
  }
  return std::abs(area);
}

}  // namespace plsc::test
