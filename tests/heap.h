#pragma once

// Counts the heap of the whole program, its libraries included (ODE calls
// malloc, not operator new). Linking heap.cc replaces malloc and its kin with
// glibc's own and a count; nothing else changes. Sanitizers have a malloc of
// their own: there nothing is counted.

#include <cstddef>

namespace plsc::test {

bool HeapIsCounted();
/// Calls of malloc, calloc, realloc and aligned forms so far, all threads.
std::size_t HeapCalls();
std::size_t HeapBytes();  ///< in use, as malloc rounds them up
std::size_t HeapPeak();   ///< most HeapBytes since the start or the reset
void ResetHeapPeak();

}  // namespace plsc::test
