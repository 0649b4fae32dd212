#pragma once

// What touches what: the robot's boxes against the ground and against each
// other. Ground is sim/ground's, sim/height_field's and sim/static_boxes's
// business; here the contacts of all kinds become rows of one shape.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sim/articulated/contact.h"
#include "sim/articulated/kinematics.h"
#include "sim/articulated/model.h"
#include "sim/engine.h"
#include "sim/ground.h"
#include "sim/height_field.h"
#include "sim/static_boxes.h"

namespace plsc::articulated {

/// Columns: the ground's axes (x right, y uphill, z the normal) in the world.
Eigen::Matrix3d GroundAxes(const Terrain& terrain);

class Collider {
 public:
  Collider(const Scene& scene, const Model& model);

  /// Contacts of the state, in an order that is a function of it, valid until
  /// the next call. Marks what touches by Body::modules. `turned` (rad) is how
  /// far any joint can have turned since the last call, so that links far from
  /// each other need not be looked at.
  const std::vector<Contact>& Find(const State& state, double turned,
                                   std::vector<bool>& touched);

  /// The state was set: distances known from before are of no use.
  void Forget();

 private:
  /// Two links that may touch.
  struct Pair {
    int a = 0, b = 0;
    double reach = 0;  ///< m, that points of both approach per rad, at most
    double due = 0;    ///< rad, turned until which they are apart
  };

  void FindGround(const State& state, int link, std::vector<bool>& touched);
  void FindStatic(const State& state, int link, std::vector<bool>& touched);
  void FindPairs(const State& state, double turned, std::vector<bool>& touched);
  double FindPair(const State& state, std::size_t pair,
                  std::vector<bool>& touched);
  void Push(int link, const FewContacts& points, std::uint64_t kind);
  std::array<Eigen::Vector3d, 3> Directions(
      const Eigen::Vector3d& normal) const;

  const Model& model_;
  Terrain terrain_;
  Eigen::Matrix3d axes_;
  std::optional<HeightField> field_;
  bool has_boxes_ = false;
  double highest_ = 0;  ///< m, of boxes on the ground
  std::vector<LinkCorners> corners_;
  std::vector<Pair> pairs_;
  double turned_ = 0, next_due_ = 0;  ///< rad
  std::vector<Contact> contacts_;
  std::vector<GroundContact> found_, upright_, leaning_;  ///< kept for memory
  std::vector<StaticBox> near_;                           ///< likewise
};

}  // namespace plsc::articulated
