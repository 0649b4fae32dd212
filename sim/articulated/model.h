#pragma once

// The robot as the articulated engine sees it, once and for all: a tree of
// links, each turned by one joint about an axis of its parent's, parents
// before children. Frames of links are the assembly's rest frame turned with
// the link, their origins the links' centres of mass.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/assembly.h"

namespace plsc::articulated {

/// A box of a link. Boxes lie along the axes of their link (modules are
/// mounted at quarter turns), so a centre and three lengths are all.
struct BoxModel {
  int module = 0;          ///< index into Body::modules
  Eigen::Vector3d centre;  ///< m, link frame
  Eigen::Vector3d half;    ///< m, half the lengths along the link's axes
  double radius = 0;       ///< m, of the sphere about it
};

struct LinkModel {
  double mass = 0;          ///< kg
  Eigen::Matrix3d inertia;  ///< kg m2, about the centre of mass
  std::vector<BoxModel> boxes;
  double radius = 0;  ///< m, from the centre of mass to the farthest corner

  // The joint that moves it; the base has none.
  int parent = -1;
  int axis = 0;            ///< 0, 1, 2: of the parent's axes, and its own
  double sign = 1;         ///< of the direction of the joint's axis along it
  Eigen::Vector3d anchor;  ///< m, parent's frame
  Eigen::Vector3d arm;     ///< m, from the anchor to the centre, own frame
};

class Model {
 public:
  explicit Model(const Assembly& assembly);

  const std::vector<LinkModel>& links() const { return links_; }
  int size() const { return static_cast<int>(links_.size()); }
  double mass() const { return mass_; }  ///< kg, of the whole robot

  /// Whether the joint of link `joint` moves `link`: all links above a link,
  /// and the link itself, have theirs between it and the base.
  bool Carries(int joint, int link) const {
    return carries_[static_cast<std::size_t>(joint) * links_.size() +
                    static_cast<std::size_t>(link)] != 0;
  }

 private:
  std::vector<LinkModel> links_;
  std::vector<std::uint8_t> carries_;
  double mass_ = 0;
};

}  // namespace plsc::articulated
