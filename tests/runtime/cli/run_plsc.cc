#include "tests/runtime/cli/run_plsc.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "runtime/cli/run.h"

namespace plsc::test {

const char* const kPlasticText = R"(plsc 1
genotype plastic
alphabet plasticoding 1
sense inclined: bool
iterations 1
rule C -> if inclined = False then { C add_front B }
rule C -> if inclined = True then {
  C add_left A2(0.5, 2.0, 3.0, 1.0) move_left add_front B
}
environment flat { inclined = False }
environment tilted { inclined = True }
)";

Ran RunPlsc(const std::vector<std::string>& arguments,
            const std::string& standard_input) {
  std::istringstream in(standard_input);
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const cli::Exit exit = cli::Main(arguments, io);
  return {static_cast<int>(exit), out.str(), err.str()};
}

std::string InRepository(const std::string& path) {
  return std::string(PLSC_SOURCE_DIR) + "/" + path;
}

std::string ReadFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

TemporaryFolder::TemporaryFolder() {
  std::string name =
      (std::filesystem::temp_directory_path() / "plsc-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::Write(const std::string& name,
                                   const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return (path_ / name).string();
}

std::vector<std::string> TemporaryFolder::Files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace plsc::test
