#pragma once

// A real run for tests of the commands that read runs: six robots, three
// generations, two seasons of a second. Made once a program.

#include <nlohmann/json.hpp>
#include <string>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc::test {

class TinyRun {
 public:
  TinyRun();
  std::string path() const { return folder_ / "run.sqlite"; }
  /// What `plsc evolve --format json` printed of it.
  const nlohmann::json& summary() const { return summary_; }

 private:
  TemporaryFolder folder_;
  nlohmann::json summary_;
};

const TinyRun& FinishedRun();

/// A copy of the run in which something is otherwise, with right checksums: as
/// another program or machine would have written it.
std::string ChangedRun(const TemporaryFolder& folder, const std::string& sql);
/// A copy that was changed behind its back.
std::string DamagedRun(const TemporaryFolder& folder, const std::string& sql);

/// YAML of such a run.
extern const char* const kTinyExperiment;

}  // namespace plsc::test
