#pragma once

// Keys and small lists as the texts of a store's columns, and back.
// What is no such text, as in a damaged file, is nothing.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/life/season_result.h"
#include "runtime/text/key.h"
#include "runtime/vary/mutate.h"

namespace plsc {

/// Of 32 hexadecimal digits, as Hex writes them.
std::optional<Key> KeyOfHex(std::string_view digits);
/// Of 16.
std::optional<std::uint64_t> WordOfHex(std::string_view digits);

/// {"inclined":"True","hot":"False"} and {"inclined":"imu","hot":"season"}.
std::string SensedText(const std::vector<SensedState>& sensed);
std::string SourcesText(const std::vector<SensedState>& sensed);
std::optional<std::vector<SensedState>> SensedOf(const std::string& sensed,
                                                 const std::string& sources);

/// ["C","A1"].
std::string HeadsText(const std::vector<SymbolId>& heads,
                      const Alphabet& alphabet);
std::optional<std::vector<SymbolId>> HeadsOf(const std::string& text,
                                             const Alphabet& alphabet);

/// {"inclined":"True"}.
std::string SensesText(const std::map<std::string, std::string>& senses);
std::optional<std::map<std::string, std::string>> SensesOf(
    const std::string& text);

}  // namespace plsc
