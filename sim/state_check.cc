// Five comparisons a link and step. Words are made only for what is wrong.

#include "sim/state_check.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "sim/height_field.h"

namespace plsc {
namespace {

// m, that all of a link may be below the ground. A fall from 10 m ends in it:
// 70 mm a step, which the next steps stop.
constexpr double kDeepest = 0.1;

// Of a square: rounding cannot make what is below it more than the limit.
constexpr double kNearly = 1 - 1e-12;

Engine::Failure Unstable(std::string reason) {
  return {Outcome::kUnstable, std::move(reason)};
}

}  // namespace

StateCheck::StateCheck(const Scene& scene)
    : physics_(scene.options.physics),
      normal_(GroundNormal(scene.terrain)),
      speed_squared_(kNearly * physics_.max_speed * physics_.max_speed),
      spin_squared_(kNearly * physics_.max_spin * physics_.max_spin),
      most_warnings_(physics_.max_solver_failures * scene.options.duration /
                     physics_.step) {
  const double hollow = scene.terrain.type == TerrainType::kRough
                            ? HeightField(scene.terrain.rough).bound()
                            : 0;
  for (const Link& link : scene.assembly.links)
    deepest_.push_back(CornersOf(link).radius + kDeepest + hollow);
}

Engine::Failure StateCheck::Look(int link, const Eigen::Vector3d& position,
                                 const LinkMotion& motion) const {
  const double speed = motion.velocity.norm();
  const double spin = motion.spin.norm();
  const double height = normal_.dot(position);
  if (!std::isfinite(speed) || !std::isfinite(spin) || !position.allFinite())
    return Unstable(fmt::format("link {} has no finite place or speed", link));
  if (speed > physics_.max_speed)
    return Unstable(
        fmt::format("link {} moves at {:.1f} m/s, more than max_speed, {} m/s",
                    link, speed, physics_.max_speed));
  if (spin > physics_.max_spin)
    return Unstable(fmt::format(
        "link {} turns at {:.1f} rad/s, more than max_spin, {} rad/s", link,
        spin, physics_.max_spin));
  if (height < -deepest_[static_cast<std::size_t>(link)])
    return {Outcome::kFellThrough,
            fmt::format("link {} is {:.3f} m below the ground", link, -height)};
  return {};
}

Engine::Failure StateCheck::LookAtSolver(int warnings) const {
  if (warnings <= most_warnings_) return {};
  return {Outcome::kSolverFailed,
          fmt::format("the solver failed {} times, more than "
                      "max_solver_failures, {} of the steps",
                      warnings, physics_.max_solver_failures)};
}

}  // namespace plsc
