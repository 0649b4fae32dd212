#pragma once

// What formulas may ask about: all that is known of a season that was lived to
// its end. In the order of runtime/develop/descriptors (body, brain,
// behaviour), then what follows from these.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plsc {

struct QuantityInfo {
  std::string_view name;     ///< as formulas print it
  std::string_view unit;     ///< empty of a number without one
  std::string_view meaning;  ///< a sentence without its end
  /// Its other name: of stores and of the authors' program. May be empty.
  std::string_view column{};
};

/// A value each is what Formula::Evaluate takes.
std::span<const QuantityInfo> Quantities();

/// By either name.
std::optional<std::size_t> FindQuantity(std::string_view name);

/// The names of the table, for suggestions.
std::span<const std::string_view> QuantityNames();

}  // namespace plsc
