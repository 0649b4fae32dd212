#include "runtime/cli/output_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "runtime/cli/open_run.h"
#include "runtime/cli/program.h"

namespace plsc::cli {

namespace {

namespace fs = std::filesystem;

const char* ProblemOf(const std::string& path,
                      const std::vector<std::string>& inputs) {
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    return "its folder does not exist";
  if (fs::is_directory(path, error)) return "it is a folder";
  if (!fs::exists(path, error)) return nullptr;
  // A file is replaced as a whole: root would do so to /dev/null, too.
  if (!fs::is_regular_file(path, error)) return "it is no regular file";
  if (std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
        return fs::equivalent(path, SplitGenotypePath(input).file, error);
      }))
    return "the command reads it; choose another name";
  if (IsDatabase(path))
    return "it is a database, as stores of runs are; choose another name";
  return nullptr;
}

}  // namespace

bool CanWrite(const std::string& path, const std::vector<std::string>& inputs,
              Io& io) {
  if (path.empty()) return true;
  const char* problem = ProblemOf(path, inputs);
  if (problem != nullptr)
    io.err << fmt::format("error: cannot write '{}': {}\n", path, problem);
  return problem == nullptr;
}

}  // namespace plsc::cli
