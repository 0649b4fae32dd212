#include "runtime/workers/worker_count.h"

#include <sched.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace plsc {

namespace {

namespace fs = std::filesystem;

/// A folder with the given files, gone at the end.
class FakeRoot {
 public:
  using Files = std::vector<std::pair<std::string, std::string>>;

  explicit FakeRoot(const Files& files) {
    std::string name = (fs::temp_directory_path() / "plsc_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
    for (const auto& [file, text] : files) {
      const fs::path full = path_ + file;
      fs::create_directories(full.parent_path());
      std::ofstream(full) << text;
    }
  }
  ~FakeRoot() { fs::remove_all(path_); }
  FakeRoot(const FakeRoot&) = delete;
  FakeRoot& operator=(const FakeRoot&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

int BoundCores() {
  cpu_set_t set;
  REQUIRE(sched_getaffinity(0, sizeof set, &set) == 0);
  return CPU_COUNT(&set);
}

}  // namespace

TEST_CASE("There is always at least one worker", "[worker_count]") {
  CHECK(WorkerCount(3) == 3);
  CHECK(WorkerCount(0) == UsableCores());
  CHECK(UsableCores() >= 1);
  CHECK(UsableCores() <= BoundCores());
}

TEST_CASE("Ranks of a machine share its cores, unless they are bound apart",
          "[worker_count]") {
  struct Row {
    const char* why;
    int own, together, ranks;
    std::vector<int> shares;
  };
  const std::vector<Row> rows = {
      {"alone", 8, 8, 1, {8}},
      {"bound to a core each", 1, 8, 4, {1, 1, 1, 1}},
      {"bound to two each", 2, 8, 4, {2, 2, 2, 2}},
      {"not bound", 8, 8, 4, {2, 2, 2, 2}},
      {"not bound, and one over", 8, 8, 3, {3, 3, 2}},
      {"two on each of two sockets", 4, 8, 4, {2, 2, 2, 2}},
      {"more than cores", 2, 2, 4, {1, 1, 1, 1}},
      {"a quota of a core and a half", 2, 2, 2, {1, 1}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    for (int rank = 0; rank < row.ranks; ++rank)
      CHECK(ShareOfRank(row.own, row.together, row.ranks, rank) ==
            row.shares[static_cast<std::size_t>(rank)]);
  }
}

TEST_CASE("A rank's share is of what its launcher says", "[worker_count]") {
  CHECK(RankWorkerCount(5) == 5);
  REQUIRE(setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "1000000", 1) == 0);
  CHECK(RankWorkerCount(0) == 1);
  REQUIRE(setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "1", 1) == 0);
  CHECK(RankWorkerCount(0) == UsableCores());
  REQUIRE(unsetenv("OMPI_COMM_WORLD_LOCAL_SIZE") == 0);
  CHECK(RankWorkerCount(0) == UsableCores());
}

TEST_CASE("Workers are no more than the cores that we are bound to",
          "[worker_count]") {
  cpu_set_t before;
  REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
  int core = 0;
  while (!CPU_ISSET(core, &before)) ++core;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(core, &one);
  REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
  CHECK(UsableCores() == 1);
  REQUIRE(sched_setaffinity(0, sizeof before, &before) == 0);
}

TEST_CASE("Workers are no more than the control groups give time for",
          "[worker_count]") {
  const int all = BoundCores();
  struct Row {
    const char* why;
    FakeRoot::Files files;
    int expected;
  };
  const char* kGroup = "/sys/fs/cgroup/job/step/cpu.max";
  const char* kSelf = "/proc/self/cgroup";
  const std::vector<Row> rows = {
      {"no control groups", {}, all},
      {"one core", {{kSelf, "0::/job/step\n"}, {kGroup, "100000 100000"}}, 1},
      {"less than a core",
       {{kSelf, "0::/job/step\n"}, {kGroup, "20000 100000\n"}},
       1},
      {"a started core counts",
       {{kSelf, "0::/job/step\n"}, {kGroup, "110000 100000\n"}},
       std::min(2, all)},
      {"no quota", {{kSelf, "0::/job/step\n"}, {kGroup, "max 100000\n"}}, all},
      {"more than there is",
       {{kSelf, "0::/job/step\n"}, {kGroup, "99900000 100000\n"}},
       all},
      {"the quota is of a group above",
       {{kSelf, "0::/job/step\n"},
        {"/sys/fs/cgroup/job/cpu.max", "50000 100000\n"},
        {kGroup, "max 100000\n"}},
       1},
      {"a container that sees only its own group",
       {{kSelf, "0::/docker/12ab\n"},
        {"/sys/fs/cgroup/cpu.max", "100000 100000\n"}},
       1},
      {"in a namespace of control groups",
       {{kSelf, "0::/\n"}, {"/sys/fs/cgroup/cpu.max", "100000 100000\n"}},
       1},
      {"version 1",
       {{kSelf, "3:memory:/m\n2:cpu,cpuacct:/job\n"},
        {"/sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "100000\n"},
        {"/sys/fs/cgroup/cpu/job/cpu.cfs_period_us", "100000\n"}},
       1},
      {"version 1 without a quota",
       {{kSelf, "2:cpu,cpuacct:/job\n"},
        {"/sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "-1\n"},
        {"/sys/fs/cgroup/cpu/job/cpu.cfs_period_us", "100000\n"}},
       all},
      {"a file that is damaged",
       {{kSelf, "nonsense\n0:\n0::job\n0::/job/step\n"}, {kGroup, "0 0\n"}},
       all}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const FakeRoot root(row.files);
      CHECK(UsableCores(root.path()) == row.expected);
    }
  }
}

}  // namespace plsc
