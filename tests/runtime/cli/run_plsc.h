#pragma once

// Runs a command in this process, as a user types it.

#include <filesystem>
#include <string>
#include <vector>

namespace plsc::test {

struct Ran {
  int exit = 0;
  std::string out;
  std::string err;
};

Ran RunPlsc(const std::vector<std::string>& arguments,
            const std::string& standard_input = "");

/// Path of a file of the repository.
std::string InRepository(const std::string& path);

std::string ReadFile(const std::filesystem::path& path);

/// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Path of `name` in the folder.
  std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }
  /// Makes a file and returns its path.
  std::string Write(const std::string& name, const std::string& text) const;
  /// Names of the files in it, sorted.
  std::vector<std::string> Files() const;

 private:
  std::filesystem::path path_;
};

/// A small correct genotype: plastic in `inclined`, environments flat and
/// tilted; a brick on flat ground, a joint with a brick on a slope.
extern const char* const kPlasticText;

}  // namespace plsc::test
