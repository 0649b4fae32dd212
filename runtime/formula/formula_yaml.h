#pragma once

// A formula as a value of YAML.

#include <optional>

#include "runtime/formula/formula.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

/// What is wrong is reported where it stands in the file.
std::optional<Formula> ReadFormula(const YamlValue& value);

}  // namespace plsc
