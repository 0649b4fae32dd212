#pragma once

// PLSC_HAS_ASAN: whether AddressSanitizer is built in, by g++ or by clang. It
// has a malloc of its own and needs more addresses than limits leave.

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
