// Random pairs of boxes through ODE's collider and our own. Both choose the
// least of 15 overlaps; ODE's contacts are other points of the same two faces.

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/sim/articulated/box_oracle.h"
#include "tests/sim/articulated/random_boxes.h"

namespace plsc {
namespace {

using test::BoxPose;
using test::ShadowAxis;

constexpr std::uint64_t kSeed = 20;
constexpr int kPoses = 100000;

/// What is compared.
struct Answer {
  int count = 0;
  double normal[3] = {};
  double depth = 0;  ///< of the deepest point
};

class OdeBoxes {
 public:
  OdeBoxes() {
    dInitODE2(0);
    for (dGeomID& geom : geoms_) geom = dCreateBox(nullptr, 1, 1, 1);
  }
  ~OdeBoxes() {
    for (const dGeomID geom : geoms_) dGeomDestroy(geom);
  }
  OdeBoxes(const OdeBoxes&) = delete;
  OdeBoxes& operator=(const OdeBoxes&) = delete;

  Answer Collide(const BoxPose& pose) {
    Place(geoms_[0], pose.first);
    Place(geoms_[1], pose.second);
    std::array<dContactGeom, kMostBoxContacts> points;
    Answer answer;
    answer.count = dCollide(geoms_[0], geoms_[1], kMostBoxContacts,
                            points.data(), sizeof(dContactGeom));
    for (int i = 0; i < answer.count; ++i) {
      const dContactGeom& point = points.at(static_cast<std::size_t>(i));
      answer.depth = std::max(answer.depth, point.depth);
      std::copy_n(point.normal, 3, answer.normal);
    }
    return answer;
  }

 private:
  static void Place(dGeomID geom, const OrientedBox& box) {
    dGeomBoxSetLengths(geom, 2 * box.half[0], 2 * box.half[1], 2 * box.half[2]);
    dGeomSetPosition(geom, box.centre[0], box.centre[1], box.centre[2]);
    dMatrix3 rotation = {};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        rotation[4 * row + column] = box.axes[column][row];
    dGeomSetRotation(geom, rotation);
  }

  dGeomID geoms_[2];
};

Answer Own(const BoxPose& pose) {
  std::array<BoxContact, kMostBoxContacts> contacts;
  Answer answer;
  answer.count = CollideBoxes(pose.first, pose.second, contacts);
  if (answer.count > 0) {
    answer.depth = contacts[0].depth;
    std::copy_n(contacts[0].normal, 3, answer.normal);
  }
  return answer;
}

double Apart(const double (&a)[3], const double (&b)[3]) {
  double square = 0;
  for (int k = 0; k < 3; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(square);
}

/// Whether two of the least overlaps are so near to each other that the order
/// of looking at them, or rounding, decides. ODE replaces the least one so far
/// by an edge pair if that is less by a twentieth, also where the first is an
/// edge pair, too; we want it to be less by a tenth of a micrometre as well.
bool IsTie(const std::vector<ShadowAxis>& axes) {
  const auto least = std::min_element(
      axes.begin(), axes.end(), [](const ShadowAxis& a, const ShadowAxis& b) {
        return a.overlap < b.overlap;
      });
  if (std::abs(least->overlap) < 1e-12L) return true;
  return std::any_of(axes.begin(), axes.end(), [&](const ShadowAxis& axis) {
    if (&axis == &*least) return false;
    const bool has_edge = axis.is_edge || least->is_edge;
    return axis.overlap < least->overlap * (has_edge ? 1.051L : 1) +
                              (has_edge ? 1.01e-7L : 1e-12L);
  });
}

TEST_CASE("Random boxes touch as ODE's do", "[box_contact]") {
  struct Tally {
    int touching = 0;                ///< as we see it
    int only_own = 0, only_ode = 0;  ///< of the touching, and of the others
    int normal = 0, depth = 0;       ///< differs
  };
  Tally clear, ties, parallel;
  OdeBoxes ode;
  test::RandomBoxes random(kSeed);
  for (int i = 0; i < kPoses; ++i) {
    const BoxPose pose = random.Next();
    const Answer own = Own(pose), other = ode.Collide(pose);
    const bool is_parallel = test::HaveParallelEdges(pose.first, pose.second);
    const bool is_tie = IsTie(test::ShadowAxes(pose.first, pose.second));
    Tally& tally = is_parallel ? parallel : is_tie ? ties : clear;
    if (own.count > 0) ++tally.touching;
    if ((own.count > 0) != (other.count > 0))
      ++(own.count > 0 ? tally.only_own : tally.only_ode);
    else if (Apart(own.normal, other.normal) > 1e-9)
      ++tally.normal;
    else if (std::abs(own.depth - other.depth) > 1e-10)
      ++tally.depth;
  }
  INFO("seed " << kSeed);
  CHECK(clear.touching > 30000);
  CHECK(clear.only_own == 0);
  CHECK(clear.only_ode == 0);
  CHECK(clear.normal == 0);
  CHECK(clear.depth == 0);
  // Another of two nearly equal ways out: 180.
  CHECK(ties.touching > 8000);
  CHECK(ties.only_own == 0);
  CHECK(ties.only_ode == 0);
  CHECK(ties.normal <= 200);
  CHECK(ties.depth == 0);
  // Where edges are parallel ODE divides rounding by rounding, and then sees
  // the boxes apart (606), or one point of edges (35), mostly along a line that
  // is no normal (263, some of them faces slanted by 1e-8). What we see is held
  // against the truth by box_contact_clip_test.cc.
  CHECK(parallel.touching > 27000);
  CHECK(parallel.only_own <= 650);
  CHECK(parallel.only_ode == 0);
  CHECK(parallel.normal <= 300);
  CHECK(parallel.depth <= 50);
}

}  // namespace
}  // namespace plsc
