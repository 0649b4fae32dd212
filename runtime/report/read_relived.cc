#include "runtime/report/read_relived.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "runtime/relive/relived_file.h"

namespace plsc {

namespace {

/// Who are the generation's robots, and that the file's are the same.
Expected<RelivedMembers, Failure> MembersInBoth(RunStore& store, int generation,
                                                RelivedFile& file) {
  Expected<std::vector<RelivedMembers>, Failure> members =
      MembersOf(store, {generation});
  if (!members) return members.error();
  RobotSums sums;
  std::vector<int> ids = members->front().survivors;
  ids.push_back(members->front().best);
  for (const int id : ids) {
    const auto sum = store.ChecksumOfBirth(id);
    if (!sum) return sum.error();
    sums.emplace(id, *sum);
  }
  if (auto failure = file.CheckRobots(sums)) return *failure;
  return std::move(members->front());
}

MaybeFailure Read(const std::string& run, int generation,
                  RelivedReading& reading) {
  RunStore store;
  if (auto failure = store.OpenForReading(run)) return failure;
  const Expected<RunIdentity, Failure> identity = IdentityOf(store);
  if (!identity) return identity.error();
  RelivedFile file;
  if (auto failure = file.OpenForReading(RelivedPathOf(run), *identity))
    return failure;
  const auto members = MembersInBoth(store, generation, file);
  if (!members) return members.error();
  Expected<std::vector<RelivedSeason>, Failure> lives = file.Lives();
  if (!lives) return lives.error();
  const bool has_any = !lives->empty();
  reading.generation = SummariseRelived(*members, identity->seasons.size(),
                                        RelivedLives(std::move(*lives)));
  reading.state = reading.generation.lives > 0 ? RelivedState::kHere
                  : has_any                    ? RelivedState::kOlder
                                               : RelivedState::kMissing;
  return std::nullopt;
}

}  // namespace

RelivedReading ReadRelived(const std::string& run, int generation) {
  std::error_code error;
  const std::string path = RelivedPathOf(run);
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error)))
    return {};
  // Somebody may add to it meanwhile: then it is read anew, now with a journal.
  constexpr int kAttempts = 3;
  RelivedReading reading;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    reading = {};
    const MaybeFailure failure = Read(run, generation, reading);
    if (!failure) return reading;
    reading.state = RelivedState::kUnusable;
    reading.problem = failure->text;
    if (failure->kind != Failure::Kind::kChanged) break;
  }
  return reading;
}

}  // namespace plsc
