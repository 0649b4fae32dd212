// Random pairs of boxes against what is true of them: shadows on all axes, and
// the exact overlap of the two faces that meet.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/sanitizer.h"
#include "tests/sim/articulated/box_oracle.h"
#include "tests/sim/articulated/random_boxes.h"
#include "tests/sim/articulated/touch.h"

namespace plsc {
namespace {

using test::BoxPose;
using test::DeepPoint;
using test::FaceOverlap;
using test::Real;
using test::ShadowAxis;
using test::Touch;
using test::TouchOf;

constexpr std::uint64_t kSeed = 21;
constexpr int kPoses = test::Sampled(100000);

Real Cosine(const double (&a)[3], const double (&b)[3]) {
  return static_cast<Real>(a[0]) * b[0] + static_cast<Real>(a[1]) * b[1] +
         static_cast<Real>(a[2]) * b[2];
}

struct Tally {
  int touching = 0;
  int edges = 0, faces = 0;
  int unseen = 0;     ///< touch in truth, but we have no contact
  int imagined = 0;   ///< the other way round
  int deeper = 0;     ///< the normal's overlap is not the least, nor nearly
  int outside = 0;    ///< points that are not in both boxes
  int through = 0;    ///< of these, behind a box thinner than the overlap
  int ambiguous = 0;  ///< no face looks more against the normal than others
  int level = 0;      ///< rounding decides whether a corner is deep
  int strange = 0;    ///< points that are no corner of the exact overlap
  int forgotten = 0;  ///< the deepest corner is not among them, or too few are
  double least_share = 1;  ///< of the area of the overlap, by four points
  double shares = 0;
  int shared = 0;
};

bool IsLevel(const FaceOverlap& overlap) {
  return std::any_of(
      overlap.corners.begin(), overlap.corners.end(),
      [](const DeepPoint& corner) { return std::abs(corner.depth) < 1e-11L; });
}

/// The points of a contact of faces against the overlap of one candidate.
void LookAtFace(const Touch& touch, const FaceOverlap& overlap,
                const OrientedBox& reference, int side, Tally& tally) {
  std::vector<DeepPoint> points;
  for (std::size_t i = 0; i < touch.count; ++i) {
    const DeepPoint point =
        test::InPlane(reference, side, touch.contacts.at(i));
    points.push_back(point);
    if (std::none_of(overlap.corners.begin(), overlap.corners.end(),
                     [&](const DeepPoint& corner) {
                       return std::hypot(corner.x - point.x, corner.y - point.y,
                                         corner.depth - point.depth) < 1e-10;
                     }))
      ++tally.strange;
  }
  Real deepest = 0;
  for (const DeepPoint& corner : overlap.corners)
    deepest = std::max(deepest, corner.depth);
  const Real area = test::HullArea(overlap.corners);
  const std::size_t wanted =
      std::min<std::size_t>(overlap.corners.size(), kMostBoxContacts);
  if (std::abs(deepest - points[0].depth) > 1e-10L) ++tally.forgotten;
  if (points.size() < wanted) {
    ++tally.forgotten;
  } else if (overlap.corners.size() > kMostBoxContacts) {
    const auto share = static_cast<double>(test::HullArea(points) / area);
    tally.least_share = std::min(tally.least_share, share);
    tally.shares += share;
    ++tally.shared;
  }
}

void LookAtTouch(const BoxPose& pose, const Touch& touch, Tally& tally) {
  const BoxContact& first = touch.contacts[0];
  const auto axes = test::ShadowAxes(pose.first, pose.second);
  Real least = std::numeric_limits<Real>::infinity();
  for (const ShadowAxis& axis : axes) least = std::min(least, axis.overlap);
  // What a point may come out of again, behind it.
  Real thickness = 1;
  bool is_face = false;
  const OrientedBox* boxes[] = {&pose.first, &pose.second};
  Tally best;
  best.strange = best.forgotten = 1000;
  for (int box = 0; box < 2; ++box)
    for (int side = 0; side < 3; ++side) {
      const OrientedBox& reference = *boxes[box];
      const Real cosine = Cosine(first.normal, reference.axes[side]);
      if (std::abs(cosine) < 1 - 1e-14L) continue;
      const Real sign = (cosine > 0 ? 1 : -1) * (box == 0 ? -1 : 1);
      const FaceOverlap overlap =
          test::OverlapOf(reference, side, sign, *boxes[1 - box]);
      is_face = true;
      thickness = std::min<Real>(thickness, 2 * reference.half[side]);
      Tally next = tally;
      if (overlap.is_ambiguous)
        ++next.ambiguous;
      else if (IsLevel(overlap))
        ++next.level;
      else
        LookAtFace(touch, overlap, reference, side, next);
      if (next.strange + next.forgotten < best.strange + best.forgotten)
        best = next;
    }
  if (is_face) tally = best;
  ++(is_face ? tally.faces : tally.edges);
  if (!is_face)
    for (const OrientedBox* box : boxes)
      thickness = std::min<Real>(
          thickness, 2 * *std::min_element(box->half, box->half + 3));
  for (std::size_t i = 0; i < touch.count; ++i) {
    const BoxContact& contact = touch.contacts.at(i);
    if (contact.depth > 1.05L * least + 1.01e-7L) ++tally.deeper;
    const Real outside = std::max(test::Outside(pose.first, contact.position),
                                  test::Outside(pose.second, contact.position));
    if (outside < 1e-10L) continue;
    ++(contact.depth > thickness ? tally.through : tally.outside);
  }
}

TEST_CASE("Contacts of random boxes are corners of the exact overlap",
          "[box_contact]") {
  Tally tally;
  test::RandomBoxes random(kSeed);
  for (int i = 0; i < kPoses; ++i) {
    const BoxPose pose = random.Next();
    const Touch touch = TouchOf(pose.first, pose.second);
    Real least = std::numeric_limits<Real>::infinity();
    for (const ShadowAxis& axis : test::ShadowAxes(pose.first, pose.second))
      least = std::min(least, axis.overlap);
    if (touch.count == 0) {
      if (least > 1e-11L) ++tally.unseen;
      continue;
    }
    ++tally.touching;
    if (least < -1e-11L) ++tally.imagined;
    LookAtTouch(pose, touch, tally);
  }
  INFO("seed " << kSeed);
  CHECK(tally.touching > test::Sampled(60000));
  CHECK(tally.edges > test::Sampled(14000));
  CHECK(tally.faces > test::Sampled(50000));
  CHECK(tally.unseen == 0);
  CHECK(tally.imagined == 0);
  CHECK(tally.deeper == 0);
  CHECK(tally.outside == 0);
  // Plates are 1 mm thick.
  CHECK(tally.through <= 15000);
  CHECK(tally.ambiguous == 0);
  // 255, most of them of faces that are parallel to rounding.
  CHECK(tally.level <= 300);
  CHECK(tally.strange == 0);
  CHECK(tally.forgotten == 0);
  CHECK(tally.shared > test::Sampled(1800));
  CHECK(tally.least_share > 0.6);
  CHECK(tally.shares / tally.shared > 0.9);
}

}  // namespace
}  // namespace plsc
