#pragma once

// What a run leaves on the disk: a new folder with run.json (what the run is
// a function of), individuals.jsonl (everybody, with genotype and evaluation)
// and generations.jsonl (who was in which pool, and who survived), one JSON
// object a line, and at the end best.pls. docs/experiments.md has the fields.
// The same run writes the same bytes. Every line is written when it happens,
// so that a run that is killed leaves all but its last line.

#include <memory>
#include <string>

#include "runtime/evolve/evolve.h"

namespace plsc {

/// One file that is written to its end, or tells why not.
class LogFile {
 public:
  LogFile() = default;
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// Makes a file that does not exist yet. What went wrong, or nothing.
  std::optional<std::string> Create(const std::string& path);
  std::optional<std::string> Write(const std::string& text);
  std::optional<std::string> Close();

 private:
  int descriptor_ = -1;
  std::string path_;
};

class RunLog : public RunObserver {
 public:
  /// Makes the folder, which must not exist (its parent must), and writes
  /// run.json. What went wrong, or nothing; a log without a folder refuses
  /// everything.
  std::optional<std::string> Create(const std::string& folder,
                                    const Experiment& experiment);

  std::optional<std::string> OnBirths(
      const std::vector<Individual>& born) override;
  std::optional<std::string> OnEvaluated(
      const Individual& one,
      const std::vector<SeasonEvidence>& evidence) override;
  std::optional<std::string> OnGeneration(
      const GenerationRecord& record) override;

  /// Writes best.pls, if there is a best, and closes the files; after Evolve,
  /// however it ended.
  std::optional<std::string> Finish(const RunResult& result);

 private:
  std::string folder_;
  LogFile individuals_;
  LogFile generations_;
};

}  // namespace plsc
