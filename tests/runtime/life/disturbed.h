#pragma once

// Disturbances to test with.

#include <functional>
#include <vector>

#include "sim/disturbance.h"

namespace plsc::test {

/// Of every kind.
inline Disturbance Everything() {
  return {
      1.0 / 3e5, 0.1 + 0.2, -2e-9, 0.7, 1.1, 0.01, {0.05, 0xffffffffffffffff},
      {0.2, 7}};
}

/// A change of each field.
inline std::vector<std::function<void(Disturbance&)>> Changes() {
  using D = Disturbance;
  return {[](D& d) { d.lift = 1e-5; },      [](D& d) { d.shift_x = 1e-5; },
          [](D& d) { d.shift_y = 1e-5; },   [](D& d) { d.yaw = 1e-5; },
          [](D& d) { d.friction = 0.9; },   [](D& d) { d.lean = 1e-5; },
          [](D& d) { d.touch = {0.1, 0}; }, [](D& d) { d.touch = {0.1, 1}; },
          [](D& d) { d.motor = {0.1, 0}; }, [](D& d) { d.motor = {0.1, 1}; }};
}

}  // namespace plsc::test
