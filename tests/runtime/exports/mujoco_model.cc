#include "tests/runtime/exports/mujoco_model.h"

#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <memory>

namespace plsc::test {

namespace {

void Add(mjVFS& files, const std::string& name, const std::string& text) {
  const int index = files.nfile;
  REQUIRE(mj_makeEmptyFileVFS(&files, name.c_str(),
                              static_cast<int>(text.size())) == 0);
  std::memcpy(files.filedata[index], text.data(), text.size());
}

}  // namespace

Loaded::Loaded(const std::string& mjcf,
               const std::map<std::string, std::string>& others) {
  const auto files = std::make_unique<mjVFS>();  // too large for the stack
  mj_defaultVFS(files.get());
  Add(*files, "robot.xml", mjcf);
  for (const auto& [name, text] : others) Add(*files, name, text);
  std::array<char, 1000> error = {};
  model_ = mj_loadXML("robot.xml", files.get(), error.data(),
                      static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  INFO(error.data());
  INFO(mjcf);
  REQUIRE(model_ != nullptr);
  CHECK(std::string(error.data()).empty());  // a warning
  data_ = mj_makeData(model_);
  mj_forward(model_, data_);
}

Loaded::~Loaded() {
  mj_deleteData(data_);
  mj_deleteModel(model_);
}

std::string Loaded::Name(mjtObj kind, int id) const {
  const char* name = mj_id2name(model_, kind, id);
  return name == nullptr ? "" : name;
}

int Loaded::Id(mjtObj kind, const std::string& name) const {
  const int id = mj_name2id(model_, kind, name.c_str());
  INFO(name);
  REQUIRE(id >= 0);
  return id;
}

int Loaded::warnings() const {
  int count = 0;
  for (const mjWarningStat& warning : data_->warning) count += warning.number;
  return count;
}

Eigen::Vector3d VectorAt(const mjtNum* numbers, int index) {
  return {numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2]};
}

Eigen::Matrix3d MatrixAt(const mjtNum* numbers, int index) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = numbers[9 * index + i];
  return matrix;
}

std::pair<double, double> LimitsOf(const mjModel& model, int joint) {
  if (model.jnt_limited[joint] == 1)
    return {model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]};
  for (int i = 0; i < model.ntendon; ++i) {
    const int wrap = model.tendon_adr[i];
    if (model.tendon_num[i] != 1 || model.wrap_type[wrap] != mjWRAP_JOINT ||
        model.wrap_objid[wrap] != joint)
      continue;
    CHECK(model.wrap_prm[wrap] == 1);
    CHECK(model.tendon_limited[i] == 1);
    return {model.tendon_range[2 * i], model.tendon_range[2 * i + 1]};
  }
  FAIL("a joint without limits");
  return {};
}

}  // namespace plsc::test
