#pragma once

// How far one run of a study is, read from its store, also while another
// process works on it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/enum_names.h"
#include "runtime/study/study.h"

namespace plsc {

enum class RunState : std::uint8_t {
  kMissing,     ///< not begun
  kUnfinished,  ///< begun, and nobody works on it
  kRunning,     ///< somebody works on it now
  kDone,        ///< all generations
  kDamaged,     ///< cannot be read, or is not the run of this study
};

inline constexpr EnumNames<RunState, 5> kRunStateNames{
    {{RunState::kMissing, "missing"},
     {RunState::kUnfinished, "unfinished"},
     {RunState::kRunning, "running"},
     {RunState::kDone, "done"},
     {RunState::kDamaged, "damaged"}}};

/// Of the best robot of the last completed generation.
struct SeasonSpeed {
  std::string season;
  std::optional<double> speed;  ///< m/s; nothing if the life was not completed
};

struct RunReport {
  RunState state = RunState::kMissing;
  std::string problem;            ///< kDamaged only
  std::string worker;             ///< kRunning only: "process 17 on host"
  int generations = 0;            ///< completed
  std::int64_t evaluations = 0;   ///< done
  std::vector<SeasonSpeed> best;  ///< by season; empty before generation 0
};

/// Looks at the run in `folder`.
RunReport ReportOn(const std::string& folder, const Study& study,
                   const StudyRun& run);

}  // namespace plsc
