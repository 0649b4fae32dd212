// Axes of hinges and boxes in the rest pose are directions of the grid, exact
// to the bit (sim/assembly turns by whole quarters). So a joint turns two
// columns of a rotation and keeps the third, and a box needs no axes of its
// own.

#include "sim/articulated/model.h"

#include <algorithm>
#include <cassert>

namespace plsc::articulated {
namespace {

using Eigen::Vector3d;

BoxModel Of(const Box& box, const Vector3d& centre) {
  return {box.module, box.centre - centre, box.axes.cwiseAbs() * box.size / 2,
          box.size.norm() / 2};
}

LinkModel Of(const Link& link) {
  LinkModel model;
  model.mass = link.mass;
  model.inertia = link.inertia;
  for (const Box& box : link.boxes) {
    model.boxes.push_back(Of(box, link.centre));
    const BoxModel& last = model.boxes.back();
    model.radius =
        std::max(model.radius, (last.centre.cwiseAbs() + last.half).norm());
  }
  return model;
}

void Mount(const Assembly& assembly, const Hinge& hinge, LinkModel& link) {
  const auto& links = assembly.links;
  link.parent = hinge.parent;
  Eigen::Index axis = 0;
  hinge.axis.cwiseAbs().maxCoeff(&axis);
  link.axis = static_cast<int>(axis);
  link.sign = hinge.axis[axis];
  assert(link.sign * link.sign == 1);
  link.anchor =
      hinge.anchor - links[static_cast<std::size_t>(hinge.parent)].centre;
  link.arm = links[static_cast<std::size_t>(hinge.child)].centre - hinge.anchor;
}

}  // namespace

Model::Model(const Assembly& assembly) {
  for (const Link& link : assembly.links) {
    links_.push_back(Of(link));
    mass_ += link.mass;
  }
  for (std::size_t i = 0; i < assembly.hinges.size(); ++i) {
    assert(assembly.hinges[i].child == static_cast<int>(i) + 1 &&
           assembly.hinges[i].parent <= static_cast<int>(i));
    Mount(assembly, assembly.hinges[i], links_[i + 1]);
  }
  const std::size_t n = links_.size();
  carries_.assign(n * n, 0);
  for (std::size_t link = 0; link < n; ++link)
    for (int joint = static_cast<int>(link); joint > 0;
         joint = links_[static_cast<std::size_t>(joint)].parent)
      carries_[static_cast<std::size_t>(joint) * n + link] = 1;
}

}  // namespace plsc::articulated
