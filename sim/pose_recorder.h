#pragma once

// Writes down where every link of a robot is, often enough to show the life
// again. Apart from sim/recorder, whose samples are for measures: they must
// not depend on whether somebody wants to see the robot.

#include <Eigen/Core>
#include <vector>

#include "sim/watcher.h"

namespace plsc {

/// One season's movement. Columns are samples; the first is the start.
struct Motion {
  double step = 0.005;              ///< s, of the simulation
  double begin = 0;                 ///< s since birth, of step 0
  std::vector<std::int64_t> steps;  ///< at which samples were taken
  Eigen::MatrixXd position;     ///< m, world frame: x, y, z of the centre of
                                ///< mass of link 0, of link 1...
  Eigen::MatrixXd turn;         ///< unit quaternions w, x, y, z, link by link:
                                ///< from the rest pose; the sign is such that
                                ///< nothing jumps
  Eigen::MatrixXd joint_angle;  ///< rad, joints in the order of Body::modules
  Eigen::MatrixXi touch;  ///< 1 where a touch sensor felt something in the
                          ///< latest step, sensors in the order of
                          ///< Body::modules

  Eigen::Index samples() const {
    return static_cast<Eigen::Index>(steps.size());
  }
  /// s since birth.
  double TimeOf(Eigen::Index sample) const {
    return begin +
           step * static_cast<double>(steps[static_cast<std::size_t>(sample)]);
  }
};

/// s, between samples. A servo turns at 1 rad/s at most, so that between two
/// of them a joint moves by 0.02 rad and its tip by less than 3 mm in a limb of
/// 15 modules: straight lines between samples cannot be told from the truth.
/// 50 a second is also what screens show.
inline constexpr double kReplayInterval = 0.02;
/// Poses (links times samples) of a season at most; longer lives are sampled
/// less often. They take 42 MB here and 8 MB in a file; 15 links have them in
/// 1000 s of life at 20 ms.
inline constexpr double kMaxPoses = 750000;

/// m. Samples of a robot that is farther away, or nowhere, are left out: worlds
/// end long before, but files must never hold what is no number.
inline constexpr double kFarthest = 1e9;

/// Steps between two samples; at least 1.
std::int64_t ReplayStride(const SimulationOptions& options, int links);

class PoseRecorder : public Watcher {
 public:
  void Begin(const Phenotype& robot, const SimulationOptions& options,
             double begin) override;
  /// Never ends a life. Keeps the steps that are a multiple of the stride, and
  /// the last.
  bool See(const World& world, std::int64_t step) override;

  /// What was seen of the season that began last; nothing, without a sample,
  /// if none began since the last call.
  Motion Take();

 private:
  void Sample(const World& world, std::int64_t step);

  Motion motion_;
  std::vector<std::size_t> sensors_;  ///< indices into Body::modules
  std::int64_t stride_ = 0;           ///< 0: not known before a world is seen
  std::int64_t last_ = 0;             ///< step of the season
  SimulationOptions options_;
  std::vector<double> positions_, turns_, angles_;  ///< sample by sample
  std::vector<int> touches_;
};

}  // namespace plsc
