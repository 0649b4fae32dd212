#pragma once

// Whether the rows that a command reads are still what was written, by their
// checksums, and whether what is not there may be missing. A failure is ready
// for the user: "'run.sqlite' is damaged: robot 9 is not as it was born".

#include <optional>
#include <string>

#include "grammar/failure.h"
#include "runtime/evolve/experiment.h"
#include "runtime/store/checksum.h"
#include "runtime/store/database.h"

namespace plsc {

/// Ids of the robots born in a generation, from 0.
struct IdSpan {
  int first = 0, last = 0;
};
IdSpan IdsBornIn(const Experiment& experiment, int generation);

class RowChecks {
 public:
  explicit RowChecks(Database& database);

  /// What the run is, with its constants.
  MaybeFailure Run();
  /// That a robot is there, as it was born, in that generation if one is named.
  MaybeFailure Birth(int id, std::optional<int> generation = std::nullopt);
  /// Its seasons, as many as there are: how many is written to `seasons`.
  MaybeFailure Evaluation(int id, int& seasons);
  /// That it is completed, with its members.
  MaybeFailure Generation(int number);

  /// Birth and evaluation of a robot that is asked for; "has no robot 99" if
  /// there is none by right.
  MaybeFailure Robot(const Experiment& experiment, int id);
  /// That no completed generation is lost. Quick.
  MaybeFailure Completed(const Experiment& experiment);

 private:
  MaybeFailure Wrong(const std::string& what);
  MaybeFailure Unborn(const Experiment& experiment, int id);
  MaybeFailure Unevaluated(const Experiment& experiment, int id);
  /// That the pages of a table are whole: rows may be lost with a page.
  MaybeFailure Pages(const char* table);

  Database& database_;
  Checksums sums_;
  Statement individual_;
  Statement evaluations_;
  Statement generation_;
  Statement completed_;
};

}  // namespace plsc
