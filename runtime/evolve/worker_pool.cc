#include "runtime/evolve/worker_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

namespace plsc {

namespace {

// A frame: the number of bytes in 8 bytes, then the bytes. Both ends are the
// same program on the same machine, so its byte order is right.
constexpr std::size_t kHeader = sizeof(std::uint64_t);

// One that kills a worker may have been unlucky (out of memory); one that
// kills two is to blame.
constexpr int kMaxDeaths = 2;

std::string Frame(const std::string& text) {
  const std::uint64_t size = text.size();
  std::string frame(kHeader, '\0');
  std::memcpy(frame.data(), &size, kHeader);
  return frame + text;
}

/// The text of a complete frame; nothing while bytes are missing.
std::optional<std::string> Unframe(const std::string& received) {
  if (received.size() < kHeader) return std::nullopt;
  std::uint64_t size = 0;
  std::memcpy(&size, received.data(), kHeader);
  if (received.size() - kHeader < size) return std::nullopt;
  return received.substr(kHeader, size);
}

bool SendAll(int socket, const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    // Without MSG_NOSIGNAL a dead receiver would end this process too.
    const ssize_t count =
        send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

/// Appends what is there, waiting for it unless `flags` say otherwise; false
/// at the end of the stream.
bool ReceiveSome(int socket, int flags, std::string& received) {
  char buffer[1 << 16];
  while (true) {
    const ssize_t count = recv(socket, buffer, sizeof(buffer), flags);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return true;
    if (count <= 0) return false;
    received.append(buffer, static_cast<std::size_t>(count));
    return true;
  }
}

std::string DescribeEnd(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {}", WTERMSIG(status));
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

std::string LastError(const char* what) {
  return fmt::format("{}: {}", what,
                     std::error_code(errno, std::generic_category()).message());
}

}  // namespace

WorkerPool::WorkerPool(const WorkerPoolOptions& options, Work work)
    : work_(std::move(work)) {
  assert(options.workers >= 1);
  for (int i = 0; i < options.workers; ++i)
    if (std::optional<Worker> worker = Start())
      workers_.push_back(std::move(*worker));
  // Fewer than asked for are still enough.
  if (!workers_.empty()) failure_.reset();
}

WorkerPool::~WorkerPool() {
  for (const Worker& worker : workers_) {
    close(worker.socket);
    kill(worker.pid, SIGKILL);
  }
  for (const Worker& worker : workers_)
    while (waitpid(worker.pid, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::optional<WorkerPool::Worker> WorkerPool::Start() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    failure_ = LastError("cannot connect to a worker");
    return std::nullopt;
  }
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    // The other workers' sockets, too: while anybody holds a copy, nobody
    // would see that the owner is gone.
    close(ends[0]);
    for (const Worker& other : workers_) close(other.socket);
    Serve(ends[1], parent);
  }
  close(ends[1]);
  if (pid < 0) {
    failure_ = LastError("cannot start a worker");
    close(ends[0]);
    return std::nullopt;
  }
  Worker worker;
  worker.pid = pid;
  worker.socket = ends[0];
  return worker;
}

void WorkerPool::Serve(int socket, pid_t parent) const {
  // Die with the parent, however it dies; it may have done so already.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  // Ctrl-C reaches the whole group; when to stop is the parent's decision.
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_DFL);  // the parent may have a handler for it
  std::string received;
  while (true) {
    if (const std::optional<std::string> request = Unframe(received)) {
      received.clear();  // the next request only comes after the answer
      try {
        if (!SendAll(socket, Frame(work_(*request)))) _exit(1);
      } catch (const std::exception&) {
        _exit(2);
      }
    } else if (!ReceiveSome(socket, 0, received)) {
      // _exit, because atexit handlers and unwritten streams are the parent's.
      _exit(0);
    }
  }
}

int WorkerPool::busy() const {
  return static_cast<int>(
      std::count_if(workers_.begin(), workers_.end(),
                    [](const Worker& worker) { return worker.request; }));
}

void WorkerPool::Submit(int ticket, std::string request) {
  waiting_.push_back({ticket, std::move(request), 0});
  HandOut();
}

void WorkerPool::CancelWaiting() {
  waiting_.clear();
}

void WorkerPool::HandOut() {
  for (Worker& worker : workers_) {
    if (waiting_.empty()) return;
    if (worker.request) continue;
    worker.request = std::move(waiting_.front());
    waiting_.pop_front();
    // If it is dead, Wait finds its socket closed and starts another one.
    SendAll(worker.socket, Frame(worker.request->text));
  }
}

std::vector<Reply> WorkerPool::Wait(int timeout_ms) {
  HandOut();
  std::vector<pollfd> polled;
  for (const Worker& worker : workers_)
    polled.push_back({worker.socket, POLLIN, 0});
  std::vector<Reply> replies;
  if (outstanding() == 0 || failure_) return replies;
  if (poll(polled.data(), polled.size(), timeout_ms) <= 0) return replies;
  for (std::size_t i = 0; i < polled.size(); ++i) {
    if (polled[i].revents == 0) continue;
    if (std::optional<Reply> reply = Receive(workers_[i]))
      replies.push_back(std::move(*reply));
  }
  // Those that could not be replaced.
  std::erase_if(workers_, [](const Worker& worker) { return worker.pid == 0; });
  if (!workers_.empty()) failure_.reset();
  HandOut();
  return replies;
}

std::optional<Reply> WorkerPool::Receive(Worker& worker) {
  if (!ReceiveSome(worker.socket, MSG_DONTWAIT, worker.received))
    return Bury(worker);
  std::optional<std::string> answer = Unframe(worker.received);
  if (!answer) return std::nullopt;
  assert(worker.request);
  Reply reply;
  reply.ticket = worker.request->ticket;
  reply.answer = std::move(answer);
  worker.request.reset();
  worker.received.clear();
  return reply;
}

// Replaces a worker that died. What it worked on is begun again, once.
std::optional<Reply> WorkerPool::Bury(Worker& worker) {
  int status = 0;
  close(worker.socket);
  // It closed its socket, so it is ending; make sure of it before waiting.
  kill(worker.pid, SIGKILL);
  while (waitpid(worker.pid, &status, 0) < 0 && errno == EINTR) {
  }
  std::optional<Reply> reply;
  if (worker.request && ++worker.request->deaths >= kMaxDeaths)
    reply = Reply{worker.request->ticket, std::nullopt, DescribeEnd(status)};
  else if (worker.request)
    waiting_.push_front(std::move(*worker.request));
  // Not to be closed by its successor.
  worker = {};
  std::optional<Worker> successor = Start();
  if (successor) worker = std::move(*successor);
  return reply;
}

}  // namespace plsc
