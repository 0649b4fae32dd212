#pragma once

// One run's relived lives beside its record, read from both files, and what
// `plsc relive` prints of them.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/relive/orders.h"
#include "runtime/report/relived.h"
#include "runtime/store/run_store.h"

namespace plsc {

struct RelivedRun {
  std::string run;   ///< path
  std::string file;  ///< path of what was lived again
  std::string other_engine;
  std::vector<std::string> seasons;
  std::vector<RelivedGeneration> generations;
  /// What the run has of robots, by id; as RelivedRobotValues::values.
  std::map<int, std::vector<std::optional<double>>> recorded;
};

/// Of the generations of `subjects`.
Expected<RelivedRun, Failure> ReadRelivedRun(RunStore& store,
                                             const ReliveSubjects& subjects,
                                             RelivedFile& file);

/// Speed by season: of the best robot and of the population, recorded and
/// relived, and what is lost if plastic robots are swapped.
std::string RelivedText(const RelivedRun& run);

/// All measures, in SI.
nlohmann::ordered_json RelivedJson(const RelivedRun& run);

}  // namespace plsc
