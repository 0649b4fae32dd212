#pragma once

// Many runs in one file: experiments that share most of their keys, each
// repeated with other seeds. Which runs there are, in which order and with
// which seeds is a function of the study alone, so that any number of
// processes can each do a part of it. Read from YAML; docs/studies.md.

#include <cstdint>
#include <string>
#include <vector>

#include "grammar/result.h"
#include "runtime/study/claim.h"
#include "runtime/study/study_experiment.h"

namespace plsc {

struct Study {
  std::string name;
  std::uint64_t seed = 1;
  int repetitions = 20;  ///< of every experiment; the paper's
  std::vector<StudyExperiment> experiments;  ///< in the order of the file
  std::vector<Claim> claims;                 ///< likewise

  friend bool operator==(const Study&, const Study&) = default;
};

/// One of the runs, "plastic/3".
struct StudyRun {
  std::size_t experiment = 0;  ///< index into Study::experiments
  int repetition = 1;          ///< from 1

  friend bool operator==(const StudyRun&, const StudyRun&) = default;
};

/// As many errors as can be found. An experiment is `base` with the keys that
/// it has itself in place of those of `base`.
Result<Study> ParseStudy(const Source& yaml);

/// Every value written out, without a base; ParseStudy returns an equal one if
/// no experiment names a file of its scenario. Two studies are equal if and
/// only if these texts are.
std::string PrintStudy(const Study& study);

/// All repetitions of the first experiment, then those of the second...
std::vector<StudyRun> RunsOf(const Study& study);

std::string RunName(const Study& study, const StudyRun& run);

/// The first 8 bytes of KeyOf("plsc study run\nseed SEED\nEXPERIMENT/N\n"), so
/// that all runs of all studies have seeds of their own, and keep them when
/// experiments or repetitions are added. (Two of 10^6 runs have the same one
/// with odds of 3 in 10^8.)
std::uint64_t SeedOf(const Study& study, const StudyRun& run);

/// What to run, with its name and seed.
Experiment ExperimentOf(const Study& study, const StudyRun& run);

/// Whether any of its experiments has.
bool HasOwnFitness(const Study& study);

}  // namespace plsc
