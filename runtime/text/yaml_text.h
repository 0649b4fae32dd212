#pragma once

// Texts as YAML.

#include <string>
#include <string_view>

namespace plsc {

/// `text` so that every reader of YAML, of 1.1 or 1.2, reads it as this very
/// string; quoted where needed.
std::string PrintYamlText(std::string_view text);

}  // namespace plsc
