// libFuzzer's main where there is no libFuzzer: runs the target on every file
// named and every file of the folders named. The usual tests replay the corpus
// with it, with g++ and whatever sanitizers they are built with.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/require.h"

namespace {

std::vector<std::filesystem::path> FilesOf(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    const std::filesystem::path path = arguments[i];
    if (!std::filesystem::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(path))
      files.push_back(entry.path());
  }
  return files;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::filesystem::path> files = FilesOf(count, arguments);
  // An empty corpus would be a test that cannot fail.
  plsc::fuzz::Require(!files.empty(), "there are files to replay");
  for (const std::filesystem::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    plsc::fuzz::Require(stream.good(), "every file can be read");
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    // Before, as whatever goes wrong may end the process.
    std::fprintf(stderr, "%s\n", file.c_str());
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                           bytes.size());
  }
  std::printf("replayed %zu files\n", files.size());
  return EXIT_SUCCESS;
}
