#pragma once

// One time that a run was worked on: who did it, when, and what it took. Kept
// beside the results, never one of them: the clock and the machine are no part
// of what a run is a function of. The store reads no clock; whoever runs it
// does.

#include <cstdint>
#include <string>

namespace plsc {

struct SessionStart {
  std::string started;  ///< UTC, "2026-03-01T12:00:00Z"
  int jobs = 0;         ///< worker processes or ranks that were asked for
};

struct SessionEnd {
  std::string ended;  ///< as SessionStart::started
  std::string how;    ///< "finished", "stopped", "failed: disk full"
  int workers = 0;
  std::int64_t evaluations = 0;  ///< of this session, as are all of these
  std::int64_t simulated = 0;    ///< seasons that were simulated
  std::int64_t looked_up = 0;    ///< seasons that were not, because known
  double seconds = 0;            ///< by the wall
  double cpu_seconds = 0;        ///< of all processes
};

}  // namespace plsc
