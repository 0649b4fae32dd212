// What must not depend on how two boxes are looked at: which is named first,
// where they are in the world, and a motion too small to matter.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/articulated/random_boxes.h"
#include "tests/sim/articulated/touch.h"

namespace plsc {
namespace {

using test::BoxPose;
using test::Touch;
using test::TouchOf;
using test::Turned;

/// Of vectors that should be equal but for the sign.
double Apart(const double (&a)[3], const double (&b)[3], double sign = 1) {
  double square = 0;
  for (int k = 0; k < 3; ++k)
    square += (a[k] - sign * b[k]) * (a[k] - sign * b[k]);
  return std::sqrt(square);
}

/// Pairs that differ, of how many.
struct Differences {
  int touching = 0, touch = 0, normal = 0, depth = 0, keys = 0;
};

void Count(const Touch& one, const Touch& other, double normal_apart,
           Differences& differences) {
  if ((one.count > 0) != (other.count > 0)) ++differences.touch;
  if (one.count == 0 || other.count == 0) return;
  ++differences.touching;
  if (normal_apart > 1e-8) ++differences.normal;
  if (std::abs(one.first().depth - other.first().depth) > 1e-11)
    ++differences.depth;
  if (one.Keys() != other.Keys()) ++differences.keys;
}

TEST_CASE("Boxes named the other way round part the other way",
          "[box_contact]") {
  Differences clear, aligned;
  test::RandomBoxes random(23);
  for (int i = 0; i < 20000; ++i) {
    const BoxPose pose = random.Next();
    const Touch touch = TouchOf(pose.first, pose.second);
    const Touch swapped = TouchOf(pose.second, pose.first);
    Count(touch, swapped,
          Apart(touch.first().normal, swapped.first().normal, -1),
          pose.turned == Turned::kFreely ? clear : aligned);
  }
  for (const Differences& d : {clear, aligned}) {
    CHECK(d.touching > 6000);
    CHECK(d.touch == 0);
    CHECK(d.depth == 0);
  }
  CHECK(clear.normal == 0);
  // Nearly parallel faces of both boxes that are equally deep to rounding.
  CHECK(aligned.normal <= 5);
}

TEST_CASE("Contacts move with their boxes", "[box_contact]") {
  Differences clear, aligned;
  double farthest = 0;
  test::RandomBoxes random(24);
  for (int i = 0; i < 20000; ++i) {
    const BoxPose pose = random.Next();
    double axes[3][3], shift[3];
    random.Rotation(axes);
    for (double& x : shift) x = random.Uniform(-1, 1);
    const Touch touch = TouchOf(pose.first, pose.second);
    const Touch moved = TouchOf(test::Moved(pose.first, axes, shift),
                                test::Moved(pose.second, axes, shift));
    double normal = 0;
    if (touch.count > 0 && moved.count > 0) {
      OrientedBox carried{};
      std::copy_n(touch.first().normal, 3, carried.axes[0]);
      carried = test::Moved(carried, axes, shift);
      normal = Apart(moved.first().normal, carried.axes[0]);
      if (touch.first().key == moved.first().key) {
        OrientedBox point{};
        std::copy_n(touch.first().position, 3, point.centre);
        point = test::Moved(point, axes, shift);
        farthest =
            std::max(farthest, Apart(point.centre, moved.first().position));
      }
    }
    Count(touch, moved, normal,
          pose.turned == Turned::kFreely ? clear : aligned);
  }
  for (const Differences& d : {clear, aligned}) {
    CHECK(d.touching > 6000);
    CHECK(d.touch == 0);
    CHECK(d.normal == 0);
    CHECK(d.depth == 0);
    CHECK(d.keys == 0);
  }
  CHECK(farthest < 1e-14);
}

TEST_CASE("Keys outlast small motions", "[box_contact]") {
  Differences clear, aligned;
  test::RandomBoxes random(25);
  for (int i = 0; i < 20000; ++i) {
    const BoxPose pose = random.Next();
    const bool is_free = pose.turned == Turned::kFreely;
    // Of aligned boxes rounding is what must not matter.
    const double size = is_free ? 1e-9 : 1e-15;
    OrientedBox next = pose.second;
    for (double& x : next.centre) x += random.Uniform(-size, size);
    for (auto& axis : next.axes)
      for (double& x : axis) x += random.Uniform(-size, size);
    const Touch touch = TouchOf(pose.first, pose.second);
    const Touch later = TouchOf(pose.first, next);
    // Less is moved away.
    if (touch.count > 0 ? touch.first().depth < 1e-8 : touch.gap < 1e-8)
      continue;
    Count(touch, later, 0, is_free ? clear : aligned);
  }
  for (const Differences& d : {clear, aligned}) {
    CHECK(d.touching > 6000);
    CHECK(d.touch == 0);
    CHECK(d.keys == 0);
  }
}

TEST_CASE("Boxes stay apart while they move by less than their gap",
          "[box_contact]") {
  test::RandomBoxes random(26);
  int apart = 0, told_by_faces = 0, wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const BoxPose pose = random.Next();
    const Touch touch = TouchOf(pose.first, pose.second);
    const double bound = BoxGapBound(pose.first, pose.second);
    if (touch.count > 0 ? touch.gap > 0 || bound > 0 : touch.gap <= 0) ++wrong;
    if (touch.count > 0) continue;
    ++apart;
    if (bound > 0) ++told_by_faces;
    if (bound > touch.gap) ++wrong;
    for (int way = 0; way < 3; ++way) {
      double direction[3];
      random.Direction(direction);
      OrientedBox moved = pose.second;
      for (int k = 0; k < 3; ++k)
        moved.centre[k] += (1 - 1e-9) * touch.gap * direction[k];
      if (TouchOf(pose.first, moved).count > 0) ++wrong;
    }
  }
  CHECK(wrong == 0);
  CHECK(apart > 6000);
  CHECK(told_by_faces > 6000);
}

}  // namespace
}  // namespace plsc
