#pragma once

// PLSC_HAS_ASAN: whether AddressSanitizer is built in, by g++ or by clang. It
// has a malloc of its own and needs more addresses than limits leave.
//
// Sampled: how often a test under a sanitizer does what it does thousands of
// times, and IsSampled which of the cases of a file or a table. What a
// sanitizer sees, it sees in some; that all of them are right is for the builds
// without to tell, where nothing is left out.

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
#define PLSC_HAS_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PLSC_HAS_ASAN 1
#endif
#endif

#if !defined(PLSC_HAS_ASAN)
#define PLSC_HAS_ASAN 0
#endif

namespace plsc::test {

/// `cases`; under AddressSanitizer a tenth of them, the first ones.
template <typename Count>
constexpr Count Sampled(Count cases) {
  return PLSC_HAS_ASAN ? (cases + 9) / 10 : cases;
}

/// How far apart those are that are taken of a file's cases. A prime, so that
/// of a table of few columns all are met.
inline constexpr std::size_t kSparser = PLSC_HAS_ASAN ? 11 : 1;

constexpr bool IsSampled(std::size_t index) {
  return index % kSparser == 0;
}

}  // namespace plsc::test
