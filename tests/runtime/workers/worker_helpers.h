#pragma once

// What the tests of workers share: collecting replies, and counting what
// happens in other processes.

#include <linux/futex.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

#include <climits>
#include <map>
#include <string>

#include "runtime/workers/workers.h"

namespace plsc::test {

constexpr int kPatience = 100;  // ms

/// Answers by ticket; for those without how the worker died.
inline std::map<int, std::string> Collect(Workers& workers) {
  std::map<int, std::string> answers;
  while (workers.outstanding() > 0 && !workers.failure())
    for (const Reply& reply : workers.Wait(kPatience))
      answers[reply.ticket] = reply.answer.value_or(reply.death);
  return answers;
}

/// A number that all processes share, and can wait for.
class SharedCounter {
 public:
  SharedCounter()
      : count_(
            static_cast<int*>(mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE,
                                   MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}
  ~SharedCounter() { munmap(count_, sizeof(int)); }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  int Increment() {
    const int count = __atomic_add_fetch(count_, 1, __ATOMIC_SEQ_CST);
    syscall(SYS_futex, count_, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
    return count;
  }
  void Set(int value) { __atomic_store_n(count_, value, __ATOMIC_SEQ_CST); }
  int value() const { return __atomic_load_n(count_, __ATOMIC_SEQ_CST); }
  /// Until it has been incremented this far.
  void WaitFor(int least) const {
    for (int seen = value(); seen < least; seen = value())
      syscall(SYS_futex, count_, FUTEX_WAIT, seen, nullptr, nullptr, 0);
  }

 private:
  int* count_;
};

/// For who hangs: until somebody kills this process.
[[noreturn]] inline void WaitForEver() {
  while (true) pause();
}

inline bool IsAlive(pid_t pid) {
  return kill(pid, 0) == 0;
}

}  // namespace plsc::test
