#include "sim/assembly.h"

#include <catch2/catch.hpp>

#include "tests/sim/authors_bodies.h"

namespace plsc {
namespace {

using nlohmann::json;

// The file's numbers are doubles with all their digits, computed in another
// order than ours: some roundings of 1e-16 apart, relative to at most 1 m.
constexpr double kExact = 1e-14;    // m, kg
constexpr double kInertia = 1e-17;  // kg m2; none is above 0.01
// But for centres of mass, which it rounds to 7 digits. None is beyond 1 m, so
// that is at most half a unit of the 7th decimal. Its inertias are about the
// unrounded centres.
constexpr double kRounded = 5.0001e-8;

Eigen::Vector3d VectorOf(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(),
          numbers.at(2).get<double>()};
}

double Distance(const Eigen::Vector3d& a, const json& b) {
  return (a - VectorOf(b)).norm();
}

std::string BoxName(const Body& body, const Box& box) {
  static const std::map<Part, std::string> endings = {
      {Part::kCore, "_CoreComponent__box_collision"},
      {Part::kBrick, "_FixedBrick__box_collision"},
      {Part::kFrame, "_ActiveHinge__frame_collision"},
      {Part::kServo, "_ActiveHinge__servo_collision"},
      {Part::kPlate, "_ActiveHinge__servo2_collision"},
      {Part::kSensor, "_TouchSensor_collision"}};
  return "component_" + Chain(body, box.module) + endings.at(box.part);
}

std::string LinkName(const Body& body, const Assembly& assembly, int link) {
  if (link == 0) return "Core";
  const auto hinge = static_cast<std::size_t>(link - 1);
  return Chain(body, assembly.hinges[hinge].module) + "_Leg";
}

void CheckBoxes(const Body& body, const Link& link, const json& expected) {
  std::map<std::string, const Box*> boxes;
  for (const Box& box : link.boxes) boxes[BoxName(body, box)] = &box;
  REQUIRE(boxes.size() == expected.size());
  for (const json& box : expected) {
    const std::string name = box.at("name").get<std::string>();
    INFO(name);
    REQUIRE(boxes.count(name) == 1);
    const Box& ours = *boxes[name];
    CHECK(Distance(ours.size, box.at("size")) < kExact);
    CHECK(Distance(ours.centre, box.at("center")) < kExact);
    for (int row = 0; row < 3; ++row)
      CHECK(Distance(ours.axes.row(row),
                     box.at("rot").at(static_cast<std::size_t>(row))) < kExact);
  }
}

/// m, of mass: from the file's own boxes, with all digits.
Eigen::Vector3d ExactCentre(const Link& ours, const Body& body,
                            const json& boxes) {
  std::map<std::string, double> masses;
  for (const Box& box : ours.boxes) masses[BoxName(body, box)] = box.mass;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const json& box : boxes)
    moment += masses.at(box.at("name").get<std::string>()) *
              VectorOf(box.at("center"));
  return moment / ours.mass;
}

void CheckLink(const Body& body, const Link& link, const json& expected) {
  CHECK(std::abs(link.mass - expected.at("mass").get<double>()) < kExact);
  CheckBoxes(body, link, expected.at("boxes"));
  const json& boxes = expected.at("boxes");
  CHECK((link.centre - ExactCentre(link, body, boxes)).norm() < kExact);
  for (int i = 0; i < 3; ++i)
    CHECK(std::abs(link.centre(i) - VectorOf(expected.at("com"))(i)) <
          kRounded);
  const json& inertia = expected.at("inertia");
  std::size_t next = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 3; ++column)
      CHECK(std::abs(link.inertia(row, column) -
                     inertia.at(next++).get<double>()) < kInertia);
}

void CheckHinges(const Body& body, const Assembly& assembly,
                 const json& expected) {
  std::map<std::string, const Hinge*> hinges;
  for (const Hinge& hinge : assembly.hinges)
    hinges["component_" + Chain(body, hinge.module) + "_ActiveHinge__joint"] =
        &hinge;
  REQUIRE(hinges.size() == expected.size());
  for (const json& joint : expected) {
    const std::string name = joint.at("name").get<std::string>();
    INFO(name);
    REQUIRE(hinges.count(name) == 1);
    const Hinge& ours = *hinges[name];
    CHECK(LinkName(body, assembly, ours.parent) ==
          joint.at("parent").get<std::string>());
    CHECK(LinkName(body, assembly, ours.child) ==
          joint.at("child").get<std::string>());
    CHECK(Distance(ours.anchor, joint.at("anchor")) < kExact);
    CHECK(Distance(ours.axis, joint.at("axis")) < kExact);
  }
}

TEST_CASE("Assemble places modules as the authors' program does",
          "[assembly]") {
  int compared = 0;
  for (const json& entry : LoadAuthorsBodies()) {
    if (!entry.contains("geometry")) continue;
    ++compared;
    INFO("case " << entry.at("case"));
    const Body body = BodyFromJson(entry.at("body"));
    const Assembly assembly = Assemble(body);
    const json& links = entry.at("geometry").at("links");
    REQUIRE(assembly.links.size() == links.size());
    for (std::size_t i = 0; i < assembly.links.size(); ++i) {
      const std::string name = LinkName(body, assembly, static_cast<int>(i));
      INFO(name);
      REQUIRE(links.contains(name));
      CheckLink(body, assembly.links[i], links.at(name));
    }
    CheckHinges(body, assembly, entry.at("geometry").at("joints"));
  }
  CHECK(compared == 20);
}

TEST_CASE("A robot weighs what its modules weigh", "[assembly]") {
  for (const json& entry : LoadAuthorsBodies()) {
    const Body body = BodyFromJson(entry.at("body"));
    double mass = 0;
    for (const Module& module : body.modules) {
      if (module.type == ModuleType::kCore) mass += 0.090;
      if (module.type == ModuleType::kBrick) mass += 0.0102;
      if (IsJoint(module.type)) mass += 0.0107;
      if (module.type == ModuleType::kTouchSensor) mass += 0.003;
    }
    CHECK(TotalMass(Assemble(body)) == Approx(mass).epsilon(1e-12));
  }
}

TEST_CASE("The axis of a joint is as its type says, wherever it sits",
          "[assembly]") {
  const ModuleType joints[] = {ModuleType::kVerticalJoint,
                               ModuleType::kHorizontalJoint};
  for (const ModuleType first : joints) {
    for (const ModuleType second : joints) {
      for (int slot = 0; slot < kSlots; ++slot) {
        Body body = LoneCore();
        const int inner = Mount(body, 0, static_cast<Slot>(slot), first);
        const int brick = Mount(body, inner, Slot::kFront, ModuleType::kBrick);
        const int outer = Mount(body, brick, Slot::kLeft, second);
        Mount(body, outer, Slot::kFront, first);
        for (const Hinge& hinge : Assemble(body).hinges) {
          const ModuleType type =
              body.modules[static_cast<std::size_t>(hinge.module)].type;
          const bool is_vertical = hinge.axis == Eigen::Vector3d::UnitZ();
          CHECK(is_vertical == (type == ModuleType::kVerticalJoint));
          if (!is_vertical) CHECK(hinge.axis.z() == 0);
        }
      }
    }
  }
}

TEST_CASE("Rigid modules share a link, joints start one", "[assembly]") {
  struct Row {
    const char* why;
    Body body;
    std::size_t links;
    std::size_t boxes_of_core;
  };
  Body bricks = LoneCore();
  const int brick = Mount(bricks, 0, Slot::kFront, ModuleType::kBrick);
  Mount(bricks, brick, Slot::kRight, ModuleType::kTouchSensor);
  const Row rows[] = {
      {"a core alone", LoneCore(), 1, 1},
      {"bricks and sensors are rigid with the core", bricks, 1, 3},
      {"each joint leaves its frame behind", Cross(), 5, 5},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const Assembly assembly = Assemble(row.body);
    CHECK(assembly.links.size() == row.links);
    CHECK(assembly.links[0].boxes.size() == row.boxes_of_core);
  }
}

}  // namespace
}  // namespace plsc
