#pragma once

// What is meant by what people write in YAML where a whole number or a truth
// value is due, and which words YAML's readers take for something else than
// text. Knows no YAML library.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plsc {

/// Of "1e3", "100.0", "1,000", "1_000", "5 robots"; of a percentage nobody
/// knows.
std::optional<std::int64_t> WholeNumberMeant(std::string text);

/// "True" or "False", of "yes", "off", "TRUE", "1", "ture"; empty: neither.
std::string TruthMeant(std::string_view text);

/// Whether some reader of YAML 1.1 or 1.2 takes the word for null, a truth
/// value or a number. Only of letters, digits and '_', no digit first.
bool IsYamlWord(std::string_view word);

}  // namespace plsc
