#include "runtime/cli/testing/files.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

namespace plsc::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kGenotypeEnd = ".pls";
constexpr std::string_view kGoldenEnd = ".golden.json";

std::string Without(std::string_view path, std::string_view end) {
  if (path.ends_with(end)) path.remove_suffix(end.size());
  return std::string(path);
}

TestPaths PathsOf(const std::string& path) {
  if (path.ends_with(kGoldenEnd))
    return {Without(path, kGoldenEnd) + std::string(kGenotypeEnd), path};
  return {path, Without(path, kGenotypeEnd) + std::string(kGoldenEnd)};
}

// The same file under two spellings is one test; a symbolic link is a test of
// its own, with a golden file of its own.
std::string Identity(const TestPaths& paths) {
  std::error_code ignored;
  const fs::path golden(paths.golden);
  fs::path folder = golden.parent_path();
  if (folder.empty()) folder = ".";
  return (fs::weakly_canonical(folder, ignored) / golden.filename()).string();
}

class Finder {
 public:
  void Add(const std::string& path) {
    const TestPaths paths = PathsOf(path);
    if (seen_.insert(Identity(paths)).second) found_.tests.push_back(paths);
  }

  void AddFolder(const std::string& folder) {
    std::set<std::string> paths;
    Collect(folder, paths);
    if (paths.empty())
      Fail(folder, fmt::format("no {} and no {} in this folder", kGenotypeEnd,
                               kGoldenEnd));
    for (const std::string& path : paths) Add(path);
  }

  FoundTests Take() { return std::move(found_); }

 private:
  void Collect(const fs::path& folder, std::set<std::string>& paths) {
    std::error_code error;
    fs::recursive_directory_iterator it(folder, error);
    // One unreadable folder must not hide the tests beside it.
    while (!error && it != fs::recursive_directory_iterator()) {
      const fs::path path = it->path();
      const std::string name = path.filename().string();
      if (name.starts_with('.'))
        it.disable_recursion_pending();
      else if (name.ends_with(kGenotypeEnd) || name.ends_with(kGoldenEnd))
        Note(*it, paths);
      it.increment(error);
    }
    if (error) Fail(folder.string(), "cannot read: " + error.message());
  }

  void Fail(const std::string& folder, const std::string& message) {
    found_.problems.push_back(
        {{folder, ""},
         {{"", Verdict::kError, {}, "error: " + message + "\n"}}});
  }

  void Note(const fs::directory_entry& entry, std::set<std::string>& paths) {
    std::error_code ignored;
    if (!entry.is_directory(ignored))
      paths.insert(PathsOf(entry.path()).genotype);
  }

  FoundTests found_;
  std::set<std::string> seen_;
};

}  // namespace

FoundTests FindTests(const std::vector<std::string>& paths) {
  Finder finder;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
      finder.AddFolder(path);
    else
      finder.Add(path);
  }
  return finder.Take();
}

}  // namespace plsc::cli
