#include "runtime/workers/worker_watch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace plsc {

std::optional<Vitals> ReadVitals(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  // "pid (name) state ..."; the name may have blanks and brackets itself. After
  // it come the state and 10 numbers, then user and system time in ticks
  // (proc(5), fields 3, 14 and 15).
  const std::size_t end = line.rfind(')');
  if (end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(end + 1));
  char state = 0;
  fields >> state;
  std::string skipped;
  for (int i = 0; i < 10; ++i) fields >> skipped;
  double user = 0;
  double system = 0;
  if (!(fields >> user >> system)) return std::nullopt;
  const auto ticks = static_cast<double>(sysconf(_SC_CLK_TCK));
  return Vitals{(user + system) / ticks, state == 'S' || state == 'T'};
}

void WorkerWatch::Add(double waited, const std::optional<Vitals>& vitals) {
  if (!vitals) {
    idle_ += waited;
    return;
  }
  const double computed = std::max(0.0, vitals->cpu - cpu_);
  cpu_ = std::max(cpu_, vitals->cpu);
  computed_ += computed;
  // Also of one that wakes now and then only to sleep again. That the owner
  // itself was stopped is in `waited` already (kLongestWait).
  if (vitals->is_idle) idle_ += std::max(0.0, waited - computed);
}

}  // namespace plsc
