#include "sim/ode/solver_order.h"

#include <cassert>

namespace plsc {
namespace {

thread_local SolverOrder* order_in_use = nullptr;

}  // namespace

int SolverOrder::Draw(int n) {
  assert(n >= 1);
  // SplitMix64 (Steele, Lea and Flood 2014): small, and good enough to shuffle.
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t bits = state_;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31;
  // The remainder's bias is n / 2^64.
  return static_cast<int>(bits % static_cast<std::uint64_t>(n));
}

UseSolverOrder::UseSolverOrder(SolverOrder& order) : previous_(order_in_use) {
  order_in_use = &order;
}

UseSolverOrder::~UseSolverOrder() {
  order_in_use = previous_;
}

}  // namespace plsc

/// Takes the place of ODE's own, which the shared library calls by name. It
/// would be defined twice if ODE were linked statically.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int dRandInt(int n) {
  // Nothing but a step draws, and a step has an order in use.
  assert(plsc::order_in_use != nullptr);
  return plsc::order_in_use->Draw(n);
}
