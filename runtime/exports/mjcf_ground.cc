// MuJoCo has planes, boxes and height fields, and so can hold all of our
// grounds but their endlessness: hills and boxes end some metres from the
// start, and the plane goes on below. It takes the larger friction of two
// bodies that meet, so the ground has the robot's.

#include "runtime/exports/mjcf_ground.h"
#include "grammar/number.h"

#include <fmt/format.h>

#include "runtime/exports/exported_ground.h"
#include "runtime/exports/number_text.h"

namespace plsc {

namespace {

using Eigen::Vector3d;

constexpr const char* kColour = "0.8 0.85 0.8 1";
constexpr const char* kField = "rough";

/// Of two that meet MuJoCo takes the larger friction: the ground's is the
/// robot's.
XmlElement Geom(const std::string& name, const std::string& type,
                const PhysicsOptions& physics) {
  return {"geom",
          {{"name", name},
           {"type", type},
           {"condim", "3"},
           {"friction", NumberText(physics.friction) + " 0.005 0.0001"},
           {"rgba", kColour}}};
}

XmlElement Plane(const RobotModel& model, double height) {
  XmlElement plane = Geom("floor", "plane", model.options.physics);
  // A plane's collisions have no end; the sizes are what is drawn.
  plane.attributes.emplace_back("size", "5 5 0.1");
  if (height != 0)
    plane.attributes.emplace_back("pos", NumbersText({0, 0, height}));
  const Eigen::Matrix3d axes = AlignedAxes(model.terrain);
  if (!axes.isIdentity(0))
    plane.attributes.emplace_back("quat", QuaternionText(axes));
  return plane;
}

/// m, of a height field below its lowest point.
constexpr double kBase = 0.1;

/// Heights from the top of a map to its bottom, as the reader takes them; it
/// scales them to 0..1 by itself, and by `size` to metres.
XmlElement Field(const ExportedGround& ground) {
  std::string heights;
  for (Eigen::Index row = ground.heights.rows() - 1; row >= 0; --row)
    for (Eigen::Index column = 0; column < ground.heights.cols(); ++column)
      heights += (heights.empty() ? "" : " ") +
                 PrintRoundedNumber(ground.heights(row, column), 6);
  const std::string reach = NumberText(ground.reach);
  return {"hfield",
          {{"name", kField},
           {"nrow", std::to_string(ground.heights.rows())},
           {"ncol", std::to_string(ground.heights.cols())},
           {"size", fmt::format("{0} {0} {1} {2}", reach,
                                NumberText(ground.highest() - ground.lowest()),
                                NumberText(kBase))},
           {"elevation", heights}}};
}

}  // namespace

MjcfGround GroundInMjcf(const RobotModel& model) {
  const ExportedGround ground = GroundOf(model.terrain);
  const PhysicsOptions& physics = model.options.physics;
  MjcfGround mjcf;
  mjcf.geoms.push_back({"light", {{"pos", "0 0 3"}, {"directional", "true"}}});
  // Beyond a field's end robots fall no farther than its lowest point.
  mjcf.geoms.push_back(Plane(model, ground.lowest()));
  if (ground.highest() > ground.lowest()) {
    mjcf.asset = XmlElement{"asset", {}, {Field(ground)}};
    XmlElement field = Geom("hills", "hfield", physics);
    field.attributes.emplace_back("hfield", kField);
    field.attributes.emplace_back("pos", NumbersText({0, 0, ground.lowest()}));
    mjcf.geoms.push_back(std::move(field));
  }
  int number = 0;
  for (const StaticBox& box : ground.boxes) {
    XmlElement geom = Geom(fmt::format("box_{}", ++number), "box", physics);
    geom.attributes.emplace_back("size", NumbersText(box.size / 2));
    geom.attributes.emplace_back("pos", NumbersText(box.centre));
    mjcf.geoms.push_back(std::move(geom));
  }
  return mjcf;
}

}  // namespace plsc
