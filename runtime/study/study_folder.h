#pragma once

// A study on the disk: FOLDER/study.yaml, the study with every value written
// out but without its claims, which are not part of what its runs are
// (claims_record.h), and FOLDER/EXPERIMENT/REPETITION.sqlite, its runs. Any
// number of processes, on any number of hosts that see the folder, may work in
// it.

#include <optional>
#include <string>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/study/study.h"

namespace plsc {

/// Makes the folder, unless it is there already and of the same study. What is
/// wrong, or nothing; a folder of another study is refused with the first line
/// in which they differ, and nothing in it is changed.
MaybeFailure PrepareFolder(const std::string& folder, const Study& study);

/// That the folder is still this study's: it may be deleted or moved while the
/// study is run.
MaybeFailure CheckFolder(const std::string& folder, const Study& study);

/// The study that a folder is of.
Expected<Study, Failure> StudyIn(const std::string& folder);

std::string RunPath(const std::string& folder, const Study& study,
                    const StudyRun& run);

}  // namespace plsc
