#include "compiler/programs.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace plsc::testing {

std::vector<std::filesystem::path> ProgramFiles() {
  std::vector<std::filesystem::path> files;
  const auto folder =
      std::filesystem::path(PLSC_SOURCE_DIR) / "tests" / "programs";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".pls") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::filesystem::path> ValidProgramFiles() {
  std::vector<std::filesystem::path> files = ProgramFiles();
  std::erase_if(files, [](const std::filesystem::path& path) {
    return !path.filename().string().starts_with("valid_");
  });
  return files;
}

std::string ReadFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace plsc::testing
