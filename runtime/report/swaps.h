#pragma once

// Whether it pays that bodies and brains differ between seasons: of each
// experiment and season what plastic robots lose if they live it with another
// season's, a number a run, and whether that is more than nothing.

#include <optional>
#include <string>
#include <vector>

#include "runtime/report/comparison.h"
#include "runtime/report/signed_rank.h"

namespace plsc {

struct RunSwap {
  std::size_t run = 0;  ///< index into StudyReport::runs
  int robots = 0;       ///< survivors that differ between seasons
  /// Means over them of the medians of their lives, in cm/s.
  double own = 0;
  double swapped = 0;
};

struct SwapLosses {
  std::string measure;     ///< "displacement_velocity_hill" or "fitness"
  std::size_t season = 0;  ///< index into StudyReport::seasons
  std::size_t experiment = 0;
  std::vector<RunSwap> runs;  ///< at least one
  BoxPlot box;                ///< of own less swapped
  /// Of the losses against 0; nothing if none differs from it.
  std::optional<SignedRank> result;
};

/// By measure, season, experiment; of runs that have plastic robots.
std::vector<SwapLosses> SwapLossesOf(const StudyReport& report);

}  // namespace plsc
