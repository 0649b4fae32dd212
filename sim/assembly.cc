// The grid of development becomes metres: module by module, parents before
// children, each one's frame follows from its parent's slot and its own back
// (SlotFrame; authors' program, pose.py:153), turned about its long axis by a
// multiple of 90 degrees. Turns are matrices of 0, 1 and -1, so that a robot at
// rest has exact coordinates and two developed alike are equal bit for bit.
//
// A joint begins a new link with what it moves (servo and plate); its frame
// belongs to the link that it is mounted on. What no joint separates is one
// rigid link: its mass, centre and inertia are summed over its boxes (parallel
// axes), in the order of the modules, which last bits depend on. Linear in the
// modules.

#include "sim/assembly.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cstddef>

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Pose {
  Matrix3d axes = Matrix3d::Identity();
  Vector3d origin = Vector3d::Zero();
};

/// A mounted module: its frame, and the link that its children join.
struct Mounted {
  Pose pose;
  int link = 0;
};

/// Turn about a coordinate axis. By whole quarters, so that every number is 0,
/// 1 or -1 and the rest pose is free of rounding.
Matrix3d QuarterTurns(const Vector3d& axis, int quarters) {
  constexpr std::array<int, 4> kCosines{1, 0, -1, 0};
  const auto index = static_cast<std::size_t>(((quarters % 4) + 4) % 4);
  const double cosine = kCosines[index];
  const double sine = kCosines[(index + 3) % 4];
  Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(),
      0;
  return cosine * Matrix3d::Identity() + sine * cross +
         (1 - cosine) * axis * axis.transpose();
}

/// Columns: the given two directions and what completes them.
Matrix3d Triad(const Vector3d& first, const Vector3d& second) {
  Matrix3d axes;
  axes << first, second, first.cross(second);
  return axes;
}

/// The pose of a child on its parent's slot; see SlotFrame for the rule.
Pose PlaceOn(const Pose& parent, const SlotFrame& slot, const SlotFrame& back,
             int angle_deg) {
  assert(angle_deg % 90 == 0);
  const Matrix3d upright =
      Triad(-(parent.axes * slot.normal), parent.axes * slot.tangent) *
      Triad(back.normal, back.tangent).transpose();
  Pose pose;
  pose.axes = upright * QuarterTurns(back.normal, -angle_deg / 90);
  pose.origin =
      parent.origin + parent.axes * slot.point - pose.axes * back.point;
  return pose;
}

Pose PoseOf(const Body& body, const Module& module,
            const std::vector<Mounted>& mounted) {
  if (module.parent == kNoModule) return {};
  const auto parent = static_cast<std::size_t>(module.parent);
  assert(parent < mounted.size());  // parents precede children
  const auto& slot = ShapeOf(body.modules[parent].type)
                         .slots[static_cast<std::size_t>(module.slot)];
  assert(slot.has_value());
  return PlaceOn(mounted[parent].pose, *slot, ShapeOf(module.type).back,
                 module.angle_deg);
}

void AddBoxes(int index, ModuleType type, const Mounted& module, int base_link,
              std::vector<Link>& links) {
  for (const PartShape& shape : ShapeOf(type).parts) {
    const Pose& pose = module.pose;
    const Box box{index,
                  shape.part,
                  shape.mass,
                  shape.size,
                  pose.origin + pose.axes * shape.centre,
                  pose.axes};
    const int owner = IsMovedByJoint(shape.part) ? module.link : base_link;
    Link& link = links[static_cast<std::size_t>(owner)];
    link.mass += shape.mass;
    // Moments first; FinishLink divides by the mass.
    link.centre += shape.mass * box.centre;
    link.boxes.push_back(box);
  }
}

Link EmptyLink() {
  return {0, Vector3d::Zero(), Matrix3d::Zero(), {}};
}

/// Of a solid box about its centre, in the frame its axes are given in.
Matrix3d BoxInertia(const Box& box) {
  const Vector3d squares = box.size.cwiseAbs2();
  const Vector3d moments =
      box.mass / 12 * (Vector3d::Constant(squares.sum()) - squares);
  return box.axes * moments.asDiagonal() * box.axes.transpose();
}

void FinishLink(Link& link) {
  link.centre /= link.mass;
  for (const Box& box : link.boxes) {
    const Vector3d arm = box.centre - link.centre;
    link.inertia +=
        BoxInertia(box) + box.mass * (arm.squaredNorm() * Matrix3d::Identity() -
                                      arm * arm.transpose());
  }
}

}  // namespace

Assembly Assemble(const Body& body) {
  assert(!body.modules.empty() && body.modules[0].type == ModuleType::kCore);
  Assembly assembly;
  assembly.links.push_back(EmptyLink());
  std::vector<Mounted> mounted;
  for (std::size_t i = 0; i < body.modules.size(); ++i) {
    const Module& module = body.modules[i];
    const int index = static_cast<int>(i);
    const int base =
        i == 0 ? 0 : mounted[static_cast<std::size_t>(module.parent)].link;
    Mounted here{PoseOf(body, module, mounted), base};
    if (IsJoint(module.type)) {
      here.link = static_cast<int>(assembly.links.size());
      assembly.links.push_back(EmptyLink());
      const Vector3d anchor =
          here.pose.origin + kHingeOffset * here.pose.axes.col(0);
      assembly.hinges.push_back(
          {index, base, here.link, anchor, here.pose.axes.col(1)});
    }
    AddBoxes(index, module.type, here, base, assembly.links);
    mounted.push_back(here);
  }
  for (Link& link : assembly.links) FinishLink(link);
  return assembly;
}

int ModulesOf(const Assembly& assembly) {
  int count = 0;
  for (const Link& link : assembly.links)
    for (const Box& box : link.boxes) count = std::max(count, box.module + 1);
  return count;
}

double TotalMass(const Assembly& assembly) {
  double mass = 0;
  for (const Link& link : assembly.links) mass += link.mass;
  return mass;
}

}  // namespace plsc
