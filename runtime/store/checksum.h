#pragma once

// What shows that rows are still what was written: SQLite itself notices
// damage to its own structure only, and a run must not go on from a number
// that a disk changed. A checksum is of all columns of what an individual, an
// evaluation, a generation or the run itself consists of, so that every value
// of every result table is under one of them.

#include <cstdint>

#include "runtime/store/database.h"

namespace plsc {

class Checksums {
 public:
  explicit Checksums(Database& database);

  /// From the rows as they are now.
  std::int64_t OfRun();
  std::int64_t OfIndividual(int id);
  /// With the phenotype and the simulation that it refers to, and its trials.
  std::int64_t OfEvaluation(int individual, int season);
  /// With its members.
  std::int64_t OfGeneration(int number);

 private:
  Statement run_;
  Statement constants_;
  Statement individual_;
  Statement evaluation_;
  bool has_trials_;
  Statement trials_;
  Statement generation_;
  Statement members_;
};

}  // namespace plsc
