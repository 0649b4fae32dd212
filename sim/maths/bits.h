#pragma once

// The bits of a number as another type: std::bit_cast, which the standard
// library of the page's module (libc++ 13) has not.

#include <type_traits>

namespace plsc {

template <typename To, typename From>
constexpr To BitCast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) &&
                std::is_trivially_copyable_v<To> &&
                std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace plsc
