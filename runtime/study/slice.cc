#include "runtime/study/slice.h"

#include <fmt/format.h>

#include "grammar/number.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

// As many jobs as the largest clusters take in an array.
constexpr int kMaxShards = 1'000'000;

bool IsNamed(const Study& study, const StudyRun& run, std::string_view only) {
  return only.empty() || only == study.experiments[run.experiment].name ||
         only == RunName(study, run);
}

}  // namespace

std::optional<Shard> ParseShard(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto number = ParseNumber<int>(text.substr(0, slash));
  const auto count = ParseNumber<int>(text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count ||
      *count > kMaxShards)
    return std::nullopt;
  return Shard{*number, *count};
}

std::vector<StudyRun> RunsIn(const Study& study, std::string_view only,
                             const Shard& shard) {
  std::vector<StudyRun> runs;
  int index = 0;
  for (const StudyRun& run : RunsOf(study)) {
    const bool is_in_shard = index++ % shard.count == shard.number - 1;
    if (is_in_shard && IsNamed(study, run, only)) runs.push_back(run);
  }
  return runs;
}

MaybeFailure CheckOnly(const Study& study, std::string_view only) {
  if (!RunsIn(study, only, {}).empty()) return std::nullopt;
  const std::string_view name = only.substr(0, only.find('/'));
  std::vector<std::string_view> known;
  for (const StudyExperiment& one : study.experiments)
    known.push_back(one.name);
  for (const std::string_view one : known)
    if (one == name)
      return fmt::format("'{}' has repetitions 1 to {}, as in '{}/1'", name,
                         study.repetitions, name);
  const auto nearest = Suggest(name, known);
  return fmt::format("the study has no experiment '{}'; {}", name,
                     nearest
                         ? fmt::format("did you mean '{}'?", *nearest)
                         : fmt::format("it has {}", fmt::join(known, ", ")));
}

}  // namespace plsc
