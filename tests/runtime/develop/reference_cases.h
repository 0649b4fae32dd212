#pragma once

// The authors' cases of tests/data: read from the unpacked files, and written
// as genotype text.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plsc::test {

using Json = nlohmann::json;

/// Names of the sets: "sample_plastic", ...
const std::vector<std::string>& ReferenceSets();

std::vector<Json> ReadReferenceCases(const std::string& set);

/// The genotype of a case as a `.pls` file that names no environments.
std::string GenotypeText(const Json& reference_case);

/// "inclined=True,hot=False".
std::string EnvironmentText(const Json& reference_case);

}  // namespace plsc::test
