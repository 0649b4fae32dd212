// A forked process that answers requests until its socket ends. After the fork
// it has copies of all that its owner had open: everything but its own socket
// is closed, or a run's file and its locks would live on in it. It dies with
// its owner, also with one that was gone before it could ask for that, ignores
// what is meant for the group, and dies by the default of signals that mean a
// crash, so that the owner can tell which. It ends by _exit: handlers and
// buffers are the owner's.

#include "runtime/workers/worker_process.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "runtime/workers/worker_frame.h"

namespace plsc {

namespace {

constexpr int kSocket = 3;  // the first after the standard streams

bool SendAll(const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    // Without MSG_NOSIGNAL a dead owner would end us by SIGPIPE.
    const ssize_t count =
        send(kSocket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

/// False at the end of the stream.
bool ReceiveSome(FrameReader& reader) {
  char buffer[1 << 16];
  while (true) {
    const ssize_t count = recv(kSocket, buffer, sizeof buffer, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    reader.Append({buffer, static_cast<std::size_t>(count)});
    return true;
  }
}

void KeepOnly(int socket) {
  if (socket != kSocket) dup2(socket, kSocket);
  if (close_range(kSocket + 1, ~0U, 0) == 0) return;
  // Linux before 5.9, as many clusters have it.
  std::vector<int> open;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/self/fd", ignored))
    open.push_back(std::atoi(entry.path().filename().c_str()));
  for (const int descriptor : open)
    if (descriptor > kSocket) close(descriptor);
}

void SetSignals(pid_t owner) {
  // Die with the owner, however it dies; it may have done so already.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != owner) _exit(1);
  // Ctrl-C reaches the whole group, and so do the ends of batch jobs and what
  // mpirun sends on; when to stop is the owner's decision.
  for (const int stop : {SIGINT, SIGTERM, SIGUSR1}) signal(stop, SIG_IGN);
  // The owner may have handlers that tell of crashes (MPI prints its stack).
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    signal(crash, SIG_DFL);
}

[[noreturn]] void Serve(const Work& work) {
  FrameReader reader;
  while (true) {
    if (const std::optional<std::string> request = reader.Take()) {
      try {
        if (!SendAll(Frame(work(*request)))) _exit(1);
      } catch (...) {
        _exit(2);
      }
    } else if (reader.is_broken()) {
      _exit(1);
    } else if (!ReceiveSome(reader)) {
      // _exit, because atexit handlers and unwritten streams are the owner's.
      _exit(0);
    }
  }
}

}  // namespace

std::optional<WorkerProcess> StartWorker(const Work& work) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return std::nullopt;
  const pid_t owner = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    KeepOnly(ends[1]);
    SetSignals(owner);
    Serve(work);
  }
  const int reason = errno;
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    errno = reason;
    return std::nullopt;
  }
  return WorkerProcess{pid, ends[0]};
}

std::string EndWorker(const WorkerProcess& worker) {
  // One that died keeps its status. Before the socket is closed, at which one
  // that lives would end by itself.
  kill(worker.pid, SIGKILL);
  int status = 0;
  while (waitpid(worker.pid, &status, 0) < 0 && errno == EINTR) {
  }
  close(worker.socket);
  if (WIFSIGNALED(status)) return fmt::format("signal {}", WTERMSIG(status));
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace plsc
