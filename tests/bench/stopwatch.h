#pragma once

// Measuring for benchmarks: how long a piece of work takes on this core.

#include <ctime>
#include <functional>

namespace plsc::bench {

// CPU time of this thread: wall time on a shared machine says little.
inline double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

/// Mean CPU time of `work` in s, repeated for `seconds` after a warm-up, at
/// least once. `work` returns something that depends on all it did, so that
/// nothing is optimised away.
inline double SecondsEach(double seconds, const std::function<double()>& work) {
  volatile double sum = work();
  const double begin = CpuSeconds();
  double elapsed = 0;
  int rounds = 0;
  do {
    sum = sum + work();
    ++rounds;
    elapsed = CpuSeconds() - begin;
  } while (elapsed < seconds);
  return elapsed / rounds;
}

}  // namespace plsc::bench
