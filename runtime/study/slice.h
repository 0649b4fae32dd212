#pragma once

// A part of a study's runs, as `--only` and `--shard` name it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/failure.h"
#include "runtime/study/study.h"

namespace plsc {

/// Every run i (from 0, in the order of RunsOf) with i mod `count` = `number` -
/// 1. So shards differ by one run at most, and each has runs of all
/// experiments, whatever these take.
struct Shard {
  int number = 1;  ///< 1 to count
  int count = 1;

  friend bool operator==(const Shard&, const Shard&) = default;
};

/// "2/8"; nothing if it is not a shard.
std::optional<Shard> ParseShard(std::string_view text);

/// The runs called `only` ("plastic/3", or "plastic" for all of them; empty
/// for all) that are in the shard, which is one of all runs of the study.
std::vector<StudyRun> RunsIn(const Study& study, std::string_view only,
                             const Shard& shard);

/// What is wrong with `only` and how to mend it; nothing if it names a run.
MaybeFailure CheckOnly(const Study& study, std::string_view only);

}  // namespace plsc
