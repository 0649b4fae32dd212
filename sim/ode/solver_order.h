#pragma once

// The order in which the iterative solver visits its rows. ODE shuffles them
// with one generator for the whole process, so that a result would depend on
// everything simulated before and on other threads. This replaces ODE's
// dRandInt by one that draws from the world being stepped. The direct solver
// draws nothing.

#include <cstdint>

namespace plsc {

/// The generator of one world.
class SolverOrder {
 public:
  /// A number from 0 to n - 1; n at least 1.
  int Draw(int n);

 private:
  std::uint64_t state_ = 0;
};

/// While it lives, ODE draws from the given generator in this thread.
class UseSolverOrder {
 public:
  explicit UseSolverOrder(SolverOrder& order);
  ~UseSolverOrder();
  UseSolverOrder(const UseSolverOrder&) = delete;
  UseSolverOrder& operator=(const UseSolverOrder&) = delete;

 private:
  SolverOrder* previous_;
};

}  // namespace plsc
