#pragma once

// The files of tests/programs.

#include <filesystem>
#include <string>
#include <vector>

namespace plsc::testing {

/// All of them, by name.
std::vector<std::filesystem::path> ProgramFiles();
/// Those whose name starts with "valid_".
std::vector<std::filesystem::path> ValidProgramFiles();

std::string ReadFile(const std::filesystem::path& path);

}  // namespace plsc::testing
