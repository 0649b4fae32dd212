#pragma once

// RUN.relived.sqlite: the lives that robots of a run lived again, beside the
// run and never in it, whose checksums say that it is as it was evolved. It
// knows by checksums which run and which robots it is of, keeps what was lived
// when the process is killed, and can be added to at any time.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/relive/relived_life.h"
#include "runtime/store/run_store.h"
#include "runtime/store/versions.h"

namespace plsc {

/// "1.sqlite" to "1.relived.sqlite".
std::string RelivedPathOf(const std::string& run);

/// Whether a file is one of these and no run, by its beginning; one that tells
/// nothing, by its name.
bool IsRelivedFile(const std::string& path);

/// Which run it is, whatever the name of its file.
struct RunIdentity {
  std::string path;  ///< for messages
  std::string name;
  std::string seed;
  /// Of its experiment, constants and versions, of which all else of it is a
  /// function.
  std::int64_t checksum = 0;
  std::vector<std::string> seasons;
};
Expected<RunIdentity, Failure> IdentityOf(RunStore& store);

/// A robot's id to the checksum under its birth: where another version went on
/// with the run, the same number may be another robot.
using RobotSums = std::map<int, std::int64_t>;

class RelivedFile {
 public:
  RelivedFile();
  ~RelivedFile();
  RelivedFile(const RelivedFile&) = delete;
  RelivedFile& operator=(const RelivedFile&) = delete;

  /// Fails for a file of another run, or that is none of these.
  MaybeFailure OpenForReading(const std::string& path, const RunIdentity& run);
  /// Makes it if it is not there. One process at a time; refused is a file
  /// that has lives by another program, which come to other bits.
  MaybeFailure OpenForWriting(const std::string& path, const RunIdentity& run);
  /// That lives of the run's own engines, or by the other one, are by this
  /// program; notes it if there are none yet.
  MaybeFailure BeginEngine(bool is_other_engine, const Versions& versions);
  /// That robots are who they were, and notes those that are new.
  MaybeFailure BeginRobots(const RobotSums& robots);
  /// What went wrong, or nothing: that the file knows other robots by these
  /// numbers.
  MaybeFailure CheckRobots(const RobotSums& robots);

  /// All of them, by LifeOf and n, compared with their checksums.
  Expected<std::vector<RelivedSeason>, Failure> Lives();
  /// In one transaction; what is there already is replaced.
  MaybeFailure Add(const std::vector<RelivedSeason>& lives);

  /// Ends the work; the only way to learn that the last writes failed.
  MaybeFailure Close();

 private:
  struct Parts;
  MaybeFailure Connect(const std::string& path, bool is_writing,
                       const RunIdentity& run);
  std::unique_ptr<Parts> parts_;
};

}  // namespace plsc
