#include "sim/overlap.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <set>

#include "tests/sim/authors_bodies.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

Box UnitBox(const Vector3d& centre, const Eigen::Matrix3d& axes) {
  return {0, Part::kBrick, 1, Vector3d::Ones(), centre, axes};
}

Eigen::Matrix3d Turned(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

TEST_CASE("BoxesOverlap finds every separating axis", "[overlap]") {
  const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d diamond = Turned(M_PI / 4, Vector3d::UnitZ());
  // Two cubes, edge towards edge and the edges crossed: only the product of
  // these edges separates them. An edge is sqrt(1/2) from its cube's centre.
  const Eigen::Matrix3d edge_up = Turned(M_PI / 4, Vector3d::UnitX());
  const Eigen::Matrix3d edge_down = Turned(M_PI / 4, Vector3d::UnitY());
  struct Row {
    const char* why;
    Vector3d centre;
    Eigen::Matrix3d axes, other_axes;
    bool is_overlap;
  };
  const Row rows[] = {
      {"the same box", Vector3d::Zero(), straight, straight, true},
      {"apart", {1.1, 0, 0}, straight, straight, false},
      {"touching", {1, 0, 0}, straight, straight, false},
      {"within the tolerance", {1 - 0.5e-7, 0, 0}, straight, straight, false},
      {"beyond the tolerance", {1 - 2e-7, 0, 0}, straight, straight, true},
      {"corner in face", {1.2, 0, 0}, straight, diamond, true},
      {"corner before face", {1.2072, 0, 0}, straight, diamond, false},
      {"corners pass", {0.9, 0.9, 0}, diamond, straight, false},
      {"crossed edges meet", {0, 0, 1.414}, edge_up, edge_down, true},
      {"crossed edges part", {0, 0, 1.4143}, edge_up, edge_down, false},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const Box a = UnitBox(Vector3d::Zero(), row.axes);
    const Box b = UnitBox(row.centre, row.other_axes);
    CHECK(BoxesOverlap(a, b) == row.is_overlap);
    CHECK(BoxesOverlap(b, a) == row.is_overlap);
  }
}

TEST_CASE("FindOverlaps agrees with the authors' program", "[overlap]") {
  int overlapping = 0;
  for (const nlohmann::json& entry : LoadAuthorsBodies()) {
    INFO("case " << entry.at("case"));
    const auto overlaps =
        FindOverlaps(Assemble(BodyFromJson(entry.at("body"))));
    const auto expected = entry.at("self_collision_pairs").get<std::size_t>();
    CHECK(overlaps.size() == expected);
    if (expected > 0) ++overlapping;
  }
  CHECK(overlapping == 5);  // else the file no longer tests this
}

TEST_CASE("Links that share a hinge never collide", "[overlap]") {
  const Assembly cross = Assemble(Cross());
  // Five links, four hinges: 10 - 4.
  CHECK(CollidingPairs(cross).size() == 6);
  for (const LinkPair& pair : CollidingPairs(cross)) {
    CHECK(pair.a < pair.b);
    CHECK(pair.a != 0);  // all four legs hang on the core
  }
  // Their boxes do intersect: the servo's hinge is inside the frame.
  CHECK(BoxesOverlap(cross.links[0].boxes[1], cross.links[1].boxes[0]));
  CHECK(FindOverlaps(cross).empty());
}

TEST_CASE("A touch sensor takes part in overlaps", "[overlap]") {
  // Bricks lead past two joints in line, 1.5 mm clear of the farther one's
  // plate; a sensor on the last brick reaches 5.6 mm out, into its servo.
  Body body = LoneCore();
  const int base = Mount(body, 0, Slot::kFront, ModuleType::kBrick);
  const int inner =
      Mount(body, base, Slot::kFront, ModuleType::kHorizontalJoint);
  const int outer =
      Mount(body, inner, Slot::kFront, ModuleType::kHorizontalJoint);
  const int corner = Mount(body, base, Slot::kRight, ModuleType::kBrick);
  const int beside = Mount(body, corner, Slot::kLeft, ModuleType::kBrick);
  const int last = Mount(body, beside, Slot::kFront, ModuleType::kBrick);
  CHECK(FindOverlaps(Assemble(body)).empty());
  const int sensor = Mount(body, last, Slot::kLeft, ModuleType::kTouchSensor);
  const Assembly assembly = Assemble(body);
  const auto overlaps = FindOverlaps(assembly);
  REQUIRE(overlaps.size() == 1);
  const auto box = [&](int link, int index) {
    return assembly.links[static_cast<std::size_t>(link)]
        .boxes[static_cast<std::size_t>(index)];
  };
  CHECK(box(overlaps[0].link_a, overlaps[0].box_a).module == sensor);
  CHECK(box(overlaps[0].link_b, overlaps[0].box_b).module == outer);
}

}  // namespace
}  // namespace plsc
