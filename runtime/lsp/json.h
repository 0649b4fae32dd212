#pragma once

// The JSON of the language server's messages. Keys are sorted by the library,
// so that equal answers are equal texts.

#include <nlohmann/json.hpp>

namespace plsc::lsp {

using Json = nlohmann::json;

}  // namespace plsc::lsp
