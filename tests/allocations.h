#pragma once

// Counts heap allocations. Linking allocations.cc replaces operator new in the
// whole program; nothing else changes.

#include <cstddef>

namespace plsc::test {

/// Calls of operator new in this program so far, all threads.
std::size_t AllocationCount();

}  // namespace plsc::test
