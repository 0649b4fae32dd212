#pragma once

// A name for content: 128 bits of a hash (XXH3), so that equal content has
// equal keys everywhere and different content, among the 10^6 things of a
// study, different ones (odds of a clash about 10^-27).

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace plsc {

struct Key {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  friend auto operator<=>(const Key&, const Key&) = default;
};

/// The same on every machine.
Key KeyOf(std::string_view content);

/// 32 digits, "00ff...".
std::string Hex(const Key& key);

}  // namespace plsc
