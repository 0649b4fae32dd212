#include "sim/pose_recorder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/schedule.h"
#include "sim/world.h"

namespace plsc {
namespace {

/// Rows of a sample each, from a list of samples.
template <typename Matrix, typename Scalar>
Matrix Columns(const std::vector<Scalar>& values, std::size_t samples) {
  if (samples == 0) return {};
  return Eigen::Map<const Matrix>(
      values.data(), static_cast<Eigen::Index>(values.size() / samples),
      static_cast<Eigen::Index>(samples));
}

bool IsShowable(const World& world) {
  for (int link = 0; link < world.links(); ++link) {
    const LinkPose pose = world.PoseOf(link);
    // Not a number compares false.
    if (!(pose.position.cwiseAbs().maxCoeff() <= kFarthest) ||
        !pose.position.allFinite() || !pose.axes.allFinite())
      return false;
  }
  return true;
}

}  // namespace

std::int64_t ReplayStride(const SimulationOptions& options, int links) {
  const double step = options.physics.step;
  const double most = std::max(kMaxPoses / std::max(links, 1), 2.0);
  const double interval = std::max(kReplayInterval, options.duration / most);
  // Beyond the steps of any life, and still a number of steps.
  constexpr double kMost = 1e15;
  return static_cast<std::int64_t>(
      std::clamp(std::ceil(interval / step - 1e-9), 1.0, kMost));
}

void PoseRecorder::Begin(const Phenotype& robot,
                         const SimulationOptions& options, double begin) {
  *this = PoseRecorder();
  options_ = options;
  motion_.step = options.physics.step;
  motion_.begin = begin;
  last_ = StepsOf(options);
  for (std::size_t i = 0; i < robot.body.modules.size(); ++i)
    if (robot.body.modules[i].type == ModuleType::kTouchSensor)
      sensors_.push_back(i);
}

bool PoseRecorder::See(const World& world, std::int64_t step) {
  if (stride_ == 0) stride_ = ReplayStride(options_, world.links());
  if (step % stride_ == 0 || step == last_) Sample(world, step);
  return true;
}

void PoseRecorder::Sample(const World& world, std::int64_t step) {
  if (!IsShowable(world)) return;
  const std::size_t before = turns_.size();
  const std::size_t width = 4 * static_cast<std::size_t>(world.links());
  motion_.steps.push_back(step);
  for (int link = 0; link < world.links(); ++link) {
    const LinkPose pose = world.PoseOf(link);
    for (const double place : pose.position) positions_.push_back(place);
    Eigen::Quaterniond turn(pose.axes);
    // q and -q are the same turn; the nearer one leaves nothing to guess.
    if (before >= width) {
      const double* old = turns_.data() + (turns_.size() - width);
      if (turn.w() * old[0] + turn.x() * old[1] + turn.y() * old[2] +
              turn.z() * old[3] <
          0)
        turn.coeffs() *= -1;
    }
    for (const double part : {turn.w(), turn.x(), turn.y(), turn.z()})
      turns_.push_back(part);
  }
  for (int joint = 0; joint < world.joints(); ++joint)
    angles_.push_back(world.JointAngle(joint));
  for (const std::size_t sensor : sensors_)
    touches_.push_back(world.touched()[sensor] ? 1 : 0);
}

Motion PoseRecorder::Take() {
  const std::size_t samples = motion_.steps.size();
  motion_.position = Columns<Eigen::MatrixXd>(positions_, samples);
  motion_.turn = Columns<Eigen::MatrixXd>(turns_, samples);
  motion_.joint_angle = Columns<Eigen::MatrixXd>(angles_, samples);
  motion_.touch = Columns<Eigen::MatrixXi>(touches_, samples);
  Motion taken = std::move(motion_);
  *this = PoseRecorder();
  return taken;
}

}  // namespace plsc
