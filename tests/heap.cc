#include "tests/heap.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>

#include "tests/sanitizer.h"

#if PLSC_HAS_ASAN

namespace plsc::test {
bool HeapIsCounted() {
  return false;
}
std::size_t HeapCalls() {
  return 0;
}
std::size_t HeapBytes() {
  return 0;
}
std::size_t HeapPeak() {
  return 0;
}
void ResetHeapPeak() {}
}  // namespace plsc::test

#else

namespace {

std::atomic<std::size_t> calls{0};
std::atomic<std::size_t> bytes{0};
std::atomic<std::size_t> peak{0};

void* Count(void* memory) {
  if (memory == nullptr) return nullptr;
  calls.fetch_add(1, std::memory_order_relaxed);
  const std::size_t now = bytes += malloc_usable_size(memory);
  std::size_t most = peak;
  while (now > most && !peak.compare_exchange_weak(most, now)) {
  }
  return memory;
}

void Discount(void* memory) {
  if (memory != nullptr) bytes -= malloc_usable_size(memory);
}

}  // namespace

// NOLINTBEGIN: glibc's names for its own allocator behind malloc.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
  return Count(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) {
  return Count(__libc_calloc(count, size));
}
void* realloc(void* memory, std::size_t size) {
  const std::size_t before = memory ? malloc_usable_size(memory) : 0;
  void* const moved = __libc_realloc(memory, size);
  if (moved == nullptr && size != 0) return nullptr;
  bytes -= before;
  return Count(moved);
}
void* memalign(std::size_t alignment, std::size_t size) {
  return Count(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return Count(__libc_memalign(alignment, size));
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = Count(__libc_memalign(alignment, size));
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) {
  Discount(memory);
  __libc_free(memory);
}
}
// NOLINTEND

namespace plsc::test {

bool HeapIsCounted() {
  return true;
}
std::size_t HeapCalls() {
  return calls;
}
std::size_t HeapBytes() {
  return bytes;
}
std::size_t HeapPeak() {
  return peak;
}
void ResetHeapPeak() {
  peak = bytes.load();
}

}  // namespace plsc::test

#endif
