// How many cores may this process use? What the machine has is the wrong answer
// in a container and in a batch job. Two limits are asked for: the set of cores
// that it is bound to, and the time that its control groups grant (both
// versions of them, each group and all above it, since a group cannot give what
// its parent has not). The smaller counts, rounded up. Ranks of one machine
// share what they have together, which their launcher's process is bound to.

#include "runtime/workers/worker_count.h"

#include <sched.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <thread>

namespace plsc {

namespace {

/// Of a process; 0: this one.
int BoundCores(pid_t process) {
  cpu_set_t set;
  // Fails on machines with more than 1024 cores, the size of the set.
  if (sched_getaffinity(process, sizeof set, &set) == 0) return CPU_COUNT(&set);
  // 0 where the system does not tell.
  return static_cast<int>(std::thread::hardware_concurrency());
}

/// Of a file of version 2: "150000 100000" is one and a half cores, "max" all.
std::optional<double> ReadCpuMax(const std::string& path) {
  std::ifstream file(path);
  double quota = 0;
  double period = 0;
  if (!(file >> quota >> period) || quota <= 0 || period <= 0)
    return std::nullopt;
  return quota / period;
}

/// Of the two files of version 1 in a folder; a quota of -1 is none.
std::optional<double> ReadCfsQuota(const std::string& folder) {
  std::ifstream quota_file(folder + "/cpu.cfs_quota_us");
  std::ifstream period_file(folder + "/cpu.cfs_period_us");
  double quota = 0;
  double period = 0;
  if (!(quota_file >> quota) || !(period_file >> period) || quota <= 0 ||
      period <= 0)
    return std::nullopt;
  return quota / period;
}

/// The least that `read` finds in the group's folder and those above it: each
/// group can only give what it has. A container may see the names of its
/// groups but only its own as the topmost folder, so missing ones are skipped.
template <typename Read>
std::optional<double> LeastAbove(const std::string& top, std::string group,
                                 const Read& read) {
  std::optional<double> least;
  while (true) {
    if (const std::optional<double> cores = read(top + group))
      least = std::min(least.value_or(*cores), *cores);
    if (group.empty()) return least;
    group.resize(group.find_last_of('/'));
  }
}

bool HasController(const std::string& controllers, const std::string& name) {
  std::istringstream list(controllers);
  std::string one;
  while (std::getline(list, one, ','))
    if (one == name) return true;
  return false;
}

/// The cores that the control groups of this process get time for. Lines of
/// /proc/self/cgroup are "number:controllers:/group"; version 2 has number 0
/// and no controllers.
std::optional<double> QuotaCores(const std::string& root) {
  std::optional<double> least;
  std::ifstream groups(root + "/proc/self/cgroup");
  std::string line;
  while (std::getline(groups, line)) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    std::string group = line.substr(second + 1);
    if (group.empty() || group.front() != '/') continue;
    if (group == "/") group.clear();
    std::optional<double> cores;
    if (controllers.empty())
      cores = LeastAbove(root + "/sys/fs/cgroup", group,
                         [](const std::string& folder) {
                           return ReadCpuMax(folder + "/cpu.max");
                         });
    else if (HasController(controllers, "cpu"))
      cores = LeastAbove(root + "/sys/fs/cgroup/cpu", group, ReadCfsQuota);
    if (cores) least = std::min(least.value_or(*cores), *cores);
  }
  return least;
}

/// `cores`, or what the control groups give time for if that is less.
int WithinQuota(int cores, const std::string& root) {
  // A part of a core is still worth a worker: all of the quota gets used.
  if (const std::optional<double> quota = QuotaCores(root))
    if (*quota < cores) cores = static_cast<int>(std::ceil(*quota));
  return std::max(1, cores);
}

std::optional<int> NumberIn(std::initializer_list<const char*> variables) {
  for (const char* name : variables)
    if (const char* value = std::getenv(name)) return std::atoi(value);
  return std::nullopt;
}

}  // namespace

int UsableCores(const std::string& root) {
  return WithinQuota(BoundCores(0), root);
}

int WorkerCount(int jobs) {
  return jobs > 0 ? jobs : UsableCores();
}

int ShareOfRank(int own, int together, int ranks, int rank) {
  if (ranks <= 1 || own * ranks <= together) return std::max(1, own);
  const int rest = together % ranks;
  return std::clamp(together / ranks + (rank < rest ? 1 : 0), 1,
                    std::max(1, own));
}

int RankWorkerCount(int jobs) {
  if (jobs > 0) return jobs;
  const int own = UsableCores();
  const int together = WithinQuota(std::max(own, BoundCores(getppid())), "");
  return ShareOfRank(
      own, together,
      NumberIn({"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"}).value_or(1),
      NumberIn({"OMPI_COMM_WORLD_LOCAL_RANK", "MPI_LOCALRANKID"}).value_or(0));
}

}  // namespace plsc
