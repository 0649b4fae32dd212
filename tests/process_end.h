#pragma once

// Waiting for the end of a child of this process, but not for ever.

#include <poll.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

namespace plsc::test {

/// Whether it has ended within so many ms; waitpid is still to be called.
inline bool EndsWithin(pid_t child, int milliseconds) {
  // Not pidfd_open: glibc 2.36 declares it as a function of C++.
  const int process = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  pollfd ended{process, POLLIN, 0};
  const bool is_over = poll(&ended, 1, milliseconds) == 1;
  close(process);
  return is_over;
}

}  // namespace plsc::test
