#pragma once

// By how much joints turn otherwise than their servos are told, of all steps
// and joints of a life. A servo within its torque turns its joint exactly as it
// is told, so the median tells how well the equations of motion were solved:
// it is near 0 where they were, whatever the few do that are held up.

#include <array>
#include <cstddef>
#include <cstdint>

namespace plsc {

class ServoErrors {
 public:
  /// rad/s, of one joint in one step; the sign does not matter.
  void Add(double error);

  /// rad/s, within 1.6 %; 0 if it is below 1e-9, or if there were none.
  double Median() const;
  double worst() const { return worst_; }  ///< rad/s, exact

 private:
  static constexpr std::size_t kBins = 1 + 40 * 32;

  std::array<std::uint32_t, kBins> counts_{};
  std::uint64_t count_ = 0;
  double worst_ = 0;
};

}  // namespace plsc
