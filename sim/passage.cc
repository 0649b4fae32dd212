// The ground changes within one instant under a robot that lives on. On planes
// it is turned with the robot on it, about the origin, so in the ground's own
// frame nothing has happened: contacts, poses and speeds are the same, only
// gravity comes from elsewhere. To put it down anew would be a fall or a rest
// that the robot did not have. Rough ground and boxes have no such frame: there
// the robot is raised or lowered besides, never moved sideways, until its
// lowest point clears the new ground, so that the physics does not begin with
// links inside of it. The joints' state is carried as it is in all cases.

#include "sim/passage.h"

#include <algorithm>
#include <cstddef>

#include "sim/assembly.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;

bool IsPlane(const Terrain& terrain) {
  return terrain.type == TerrainType::kFlat ||
         terrain.type == TerrainType::kTilted;
}

/// Of all links where they are.
double GapOf(const LifeState& state, const Assembly& assembly,
             const Terrain& terrain) {
  double gap = 0;
  for (std::size_t i = 0; i < assembly.links.size(); ++i) {
    Assembly one;
    one.links.push_back(assembly.links[i]);
    // The link's own frame has its origin at its centre of mass.
    const LinkPose& pose = state.poses[i];
    const Placement placement{
        pose.position - pose.axes * assembly.links[i].centre, pose.axes};
    const double next = Gap(one, placement, terrain);
    gap = i == 0 ? next : std::min(gap, next);
  }
  return gap;
}

}  // namespace

LifeState Carry(const LifeState& state, const Phenotype& phenotype,
                const Passage& passage) {
  LifeState carried = state;
  if (passage.from == passage.to) return carried;
  const Matrix3d turn =
      AlignedAxes(passage.to) * AlignedAxes(passage.from).transpose();
  carried.core = {turn * state.core.position, turn * state.core.axes};
  for (LinkPose& pose : carried.poses)
    pose = {turn * pose.position, turn * pose.axes};
  for (LinkMotion& motion : carried.motions)
    motion = {turn * motion.velocity, turn * motion.spin};
  if (IsPlane(passage.from) && IsPlane(passage.to)) return carried;
  const double lift =
      passage.clearance - GapOf(carried, Assemble(phenotype.body), passage.to);
  carried.core.position.z() += lift;
  for (LinkPose& pose : carried.poses) pose.position.z() += lift;
  return carried;
}

}  // namespace plsc
