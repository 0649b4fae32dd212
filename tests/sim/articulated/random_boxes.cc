#include "tests/sim/articulated/random_boxes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/sim/articulated/box_oracle.h"

namespace plsc::test {
namespace {

// m. Parts of modules (sim/modules.cc), from the core to the plate.
constexpr double kParts[][3] = {
    {0.089, 0.089, 0.045},    {0.041, 0.041, 0.0355}, {0.022, 0.03575, 0.010},
    {0.0245, 0.02575, 0.015}, {0.001, 0.034, 0.034},  {0.0041, 0.031, 0.0155}};

constexpr double kSlants[] = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};

/// Turns two of a box's sides about the third.
void TurnAbout(OrientedBox& box, int side, double cosine, double sine) {
  double(&u)[3] = box.axes[(side + 1) % 3];
  double(&v)[3] = box.axes[(side + 2) % 3];
  for (int k = 0; k < 3; ++k) {
    const double before = u[k];
    u[k] = cosine * before + sine * v[k];
    v[k] = cosine * v[k] - sine * before;
  }
}

}  // namespace

std::uint64_t RandomBoxes::Bits() {
  // SplitMix64.
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t bits = state_;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31);
}

double RandomBoxes::Uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(Bits() >> 11) * 0x1p-53);
}

void RandomBoxes::Direction(double (&direction)[3]) {
  while (true) {
    double square = 0;
    for (double& x : direction) {
      x = Uniform(-1, 1);
      square += x * x;
    }
    if (square > 1 || square < 1e-4) continue;
    for (double& x : direction) x /= std::sqrt(square);
    return;
  }
}

void RandomBoxes::Rotation(double (&axes)[3][3]) {
  double q[4];
  double square = 0;
  do {
    square = 0;
    for (double& x : q) {
      x = Uniform(-1, 1);
      square += x * x;
    }
  } while (square > 1 || square < 1e-4);
  for (double& x : q) x /= std::sqrt(square);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double columns[3][3] = {
      {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
      {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
      {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
  for (int i = 0; i < 3; ++i) std::copy_n(columns[i], 3, axes[i]);
}

void RandomBoxes::Size(OrientedBox& box) {
  const bool is_part = Bits() % 4 != 0;
  const std::uint64_t part = Bits() % std::size(kParts);
  for (int k = 0; k < 3; ++k)
    box.half[k] = (is_part ? kParts[part][k] : Uniform(0.001, 0.1)) / 2;
}

void RandomBoxes::Turn(BoxPose& pose) {
  Rotation(pose.first.axes);
  Rotation(pose.second.axes);
  constexpr Turned kTurned[] = {
      Turned::kFreely,       Turned::kFreely,        Turned::kFreely,
      Turned::kAboutOneSide, Turned::kByRightAngles, Turned::kNearRightAngles};
  pose.turned = kTurned[Bits() % std::size(kTurned)];
  if (pose.turned == Turned::kFreely) return;
  for (int i = 0; i < 3; ++i)
    std::copy_n(pose.first.axes[i], 3, pose.second.axes[i]);
  for (int side = 0; side < 3; ++side)
    if (Bits() % 2 != 0) TurnAbout(pose.second, side, 0, 1);
  if (pose.turned == Turned::kAboutOneSide) {
    double direction[3];
    Direction(direction);
    const double length =
        std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
    TurnAbout(pose.second, static_cast<int>(Bits() % 3), direction[0] / length,
              direction[1] / length);
  } else if (pose.turned == Turned::kNearRightAngles) {
    const double slant = kSlants[Bits() % std::size(kSlants)];
    for (int side = 0; side < 3; ++side) {
      const double sine = slant * Uniform(-1, 1);
      TurnAbout(pose.second, side, std::sqrt(1 - sine * sine), sine);
    }
  }
}

BoxPose RandomBoxes::Next() {
  BoxPose pose{};
  Size(pose.first);
  Size(pose.second);
  Turn(pose);
  double way[3];
  Direction(way);
  const double touching = TouchingDistance(pose.first, pose.second, way);
  const double part = Uniform(0, 1);
  const double depth =
      Bits() % 3 == 0 ? -0.05 * part * part : 0.02 * part * part * part * part;
  for (int k = 0; k < 3; ++k) {
    pose.first.centre[k] = Uniform(-0.5, 0.5);
    pose.second.centre[k] = pose.first.centre[k] +
                            std::max(touching - depth, touching / 50) * way[k];
  }
  return pose;
}

OrientedBox RandomBoxes::NextBox() {
  OrientedBox box{};
  Size(box);
  Rotation(box.axes);
  return box;
}

OrientedBox Moved(const OrientedBox& box, const double (&axes)[3][3],
                  const double (&shift)[3]) {
  const auto turned = [&](const double(&from)[3], double(&to)[3]) {
    for (int k = 0; k < 3; ++k)
      to[k] =
          axes[0][k] * from[0] + axes[1][k] * from[1] + axes[2][k] * from[2];
  };
  OrientedBox moved = box;
  turned(box.centre, moved.centre);
  for (int k = 0; k < 3; ++k) {
    moved.centre[k] += shift[k];
    turned(box.axes[k], moved.axes[k]);
  }
  return moved;
}

}  // namespace plsc::test
