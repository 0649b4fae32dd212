#include "runtime/cli/files/open_run.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string_view>

#include "grammar/number.h"
#include "grammar/shown_line.h"

namespace plsc::cli {

bool IsDatabase(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  // https://www.sqlite.org/fileformat.html, 1.3.1
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  std::array<char, kMagic.size()> begin{};
  std::ifstream file(path, std::ios::binary);
  return file.read(begin.data(), begin.size()) &&
         std::string_view(begin.data(), begin.size()) == kMagic;
}

Exit Complain(const Failure& failure, Io& io) {
  io.err << fmt::format("error: {}\n", Escaped(failure.text));
  return Exit::kBadInput;
}

Expected<int, Failure> IdOf(RunStore& store, const std::string& name) {
  if (name == "best") {
    const Expected<RunStatus, Failure> status = store.Status();
    if (!status) return status.error();
    if (status->best == 0)
      return Failure("no generation is completed yet, so nobody is best");
    return status->best;
  }
  const std::optional<int> id = ParseNumber<int>(name);
  if (!id || *id < 1)
    return Failure(fmt::format(
        "expected the number of a robot, from 1, or best; found '{}'", name));
  return *id;
}

Expected<std::vector<int>, Failure> IdsOf(
    RunStore& store, const std::vector<std::string>& names) {
  std::vector<int> ids;
  for (const std::string& name :
       names.empty() ? std::vector<std::string>{"best"} : names) {
    const Expected<int, Failure> id = IdOf(store, name);
    if (!id) return id.error();
    ids.push_back(*id);
  }
  return ids;
}

Expected<std::vector<int>, Failure> EvaluatedIds(RunStore& store) {
  Expected<std::vector<int>, Failure> ids = store.EvaluatedIds();
  if (ids && ids->empty()) return Failure("nobody is evaluated yet");
  return ids;
}

std::string VersionsText(const Versions& versions) {
  const std::string text =
      fmt::format("plsc {}, results {}", versions.plsc, versions.results);
  return Escaped(versions.machine == kAnyMachine
                     ? text + ", the same on any machine"
                     : fmt::format("{}, ODE {}, compiler {}", text,
                                   versions.ode, versions.compiler));
}

}  // namespace plsc::cli
