#pragma once

// Programs of the machine, for tests of what is made for them.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace plsc::test {

inline bool HasProgram(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

struct ShellRan {
  int status = 0;
  std::string out;  ///< and what it said on standard error
};

inline ShellRan RunShell(const std::string& command) {
  ShellRan ran;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {-1, ""};
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) !=
         nullptr)
    ran.out += buffer.data();
  ran.status = pclose(pipe);
  return ran;
}

}  // namespace plsc::test
