#include "sim/ode/solver_order.h"

#include <catch2/catch.hpp>
#include <vector>

extern "C" int dRandInt(int n);

namespace plsc {
namespace {

TEST_CASE("Draws are in range and reach every value", "[solver_order]") {
  SolverOrder order;
  CHECK(order.Draw(1) == 0);
  std::vector<int> counts(7);
  for (int i = 0; i < 7000; ++i)
    ++counts.at(static_cast<std::size_t>(order.Draw(7)));
  // 1000 expected, with a standard deviation of 29.
  for (const int count : counts) CHECK(std::abs(count - 1000) < 150);
}

TEST_CASE("ODE draws from the order in use, the innermost first",
          "[solver_order]") {
  SolverOrder outer, inner, twin;
  const UseSolverOrder use_outer(outer);
  const int first = dRandInt(1000000);
  CHECK(first == twin.Draw(1000000));
  {
    const UseSolverOrder use_inner(inner);
    CHECK(dRandInt(1000000) == first);
  }
  CHECK(dRandInt(1000000) == twin.Draw(1000000));
}

}  // namespace
}  // namespace plsc
