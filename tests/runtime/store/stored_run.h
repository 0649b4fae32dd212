#pragma once

// Small runs to be stored: every robot really develops, and is evaluated by a
// look at it instead of by physics (tests/runtime/evolve/fake_run.h).

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/store/run_store.h"
#include "tests/runtime/evolve/fake_run.h"

namespace plsc::test {

/// A folder of its own that goes away with the object.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }
  const std::filesystem::path& path() const { return path_; }
  std::vector<std::string> Files() const;  ///< sorted

 private:
  std::filesystem::path path_;
};

/// SmallExperiment with every kind of what a store keeps: two states, a real
/// one among them, and seasons that tell or do not tell.
Experiment StoredExperiment();

/// What a run of it shows to its observers; every bit of behaviour is some
/// number, not only a few whole ones.
Recorder RecordRun(const Experiment& experiment);

/// Reports to a store what was recorded, evaluations of a generation in this
/// order: 0 as they are, 1 backwards, 2 and more by other mixtures.
/// `generations` completed ones, and then the births and half the evaluations
/// of the next, if there is one. Empty, or what went wrong.
std::string Report(const Recorder& recorder, RunStore& store, int order = 0,
                   int generations = 1000);

/// A store with such a run, closed; made once a program, then copied.
void WriteRun(const std::string& path, int generations = 1000);

/// The same with two trials a robot and noise of every kind, three generations.
void WriteTriedRun(const std::string& path);

std::string ReadBytes(const std::string& path);
void WriteBytes(const std::string& path, const std::string& bytes);

}  // namespace plsc::test
