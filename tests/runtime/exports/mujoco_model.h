#pragma once

// What MuJoCo understood of a file: its model, and its state at rest.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <map>
#include <string>
#include <utility>

namespace plsc::test {

/// A model of MuJoCo with its state, computed once at rest.
class Loaded {
 public:
  /// `others`: files that the first may include, by name.
  explicit Loaded(const std::string& mjcf,
                  const std::map<std::string, std::string>& others = {});
  ~Loaded();
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  const mjModel& model() const { return *model_; }
  /// To be changed before the first step.
  mjModel& changed() { return *model_; }
  const mjData& data() const { return *data_; }
  void SetControl(int actuator, double value) { data_->ctrl[actuator] = value; }
  /// After a change of the model.
  void Compute() { mj_forward(model_, data_); }
  void Step() { mj_step(model_, data_); }
  std::string Name(mjtObj kind, int id) const;
  /// Of what must be there.
  int Id(mjtObj kind, const std::string& name) const;
  int warnings() const;

 private:
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

Eigen::Vector3d VectorAt(const mjtNum* numbers, int index);
/// MuJoCo's are by rows.
Eigen::Matrix3d MatrixAt(const mjtNum* numbers, int index);

/// rad: the joint's own, or those of the tendon that is nothing but it.
std::pair<double, double> LimitsOf(const mjModel& model, int joint);

}  // namespace plsc::test
