#pragma once

// A life that is lived now and recorded, for simulate --record and for view.

#include <iosfwd>
#include <string>

#include "runtime/cli/files/io.h"
#include "runtime/cli/running/simulation_watch.h"
#include "runtime/life/life.h"
#include "runtime/recording/recording.h"

namespace plsc::cli {

/// What a life hangs on beside the genotype and the scenario.
struct Circumstances {
  Senses inherited;
  Disturbances disturbances;
};

class RecordedLife {
 public:
  /// Shows progress if standard error is a terminal. Without `is_recording`
  /// the recording has no seasons.
  RecordedLife(const Genotype& genotype, const Scenario& scenario,
               const Circumstances& circumstances, bool is_recording, Io& io);

  bool is_over() const { return life_.is_over(); }
  /// Lives the next season.
  SeasonLife Next();
  /// Of the seasons so far.
  const Recording& recording() const { return recording_; }

 private:
  const Scenario scenario_;
  bool is_recording_ = false;
  SimulationWatch watch_;
  Life life_;
  Recording recording_;
  std::size_t lived_ = 0;  // seasons
};

}  // namespace plsc::cli
