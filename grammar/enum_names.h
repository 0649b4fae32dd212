#pragma once

// The names of an enumeration's values in one table, read both ways: what is
// written under a name is read by the same one.

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace plsc {

/// A line a value, in the order in which people are told of them.
template <typename E, std::size_t N>
using EnumNames = std::array<std::pair<E, std::string_view>, N>;

template <typename E, std::size_t N>
constexpr std::string_view NameIn(const EnumNames<E, N>& names,
                                  std::type_identity_t<E> value) {
  for (const auto& [one, name] : names)
    if (one == value) return name;
  assert(false);  // the table lacks it
  return "";
}

/// Nothing where no value has that name.
template <typename E, std::size_t N>
constexpr std::optional<E> ValueIn(const EnumNames<E, N>& names,
                                   std::string_view name) {
  for (const auto& [value, its] : names)
    if (its == name) return value;
  return std::nullopt;
}

/// All of them, to say what was expected.
template <typename E, std::size_t N>
std::vector<std::string_view> AllNames(const EnumNames<E, N>& names) {
  std::vector<std::string_view> all;
  for (const auto& [value, name] : names) all.push_back(name);
  return all;
}

}  // namespace plsc
