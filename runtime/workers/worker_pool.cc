// One thread, one poll over the workers' sockets, nothing that blocks: an owner
// that waits in a write while its worker waits in a write of an answer would
// wait for ever, and requests and answers may be larger than a socket's buffer.
// Each worker has one request at a time, so its socket carries one text in each
// direction.
//
// A request is at any time in exactly one place: it waits, or a worker has it.
// It leaves with exactly one reply, or is cancelled while it waits. Whatever is
// wrong with a worker (its socket closed, no frame, an answer to nothing, no
// answer for too long) has one consequence: it is killed and reaped, another is
// started, and its request goes to the front of the queue, once. Who kills two
// workers is answered with how the second died, as the next would die of it
// too.
//
// Time is measured only to find those that hang, and as their own time
// (worker_watch), since a machine that sleeps must not kill them all. No result
// depends on it.
//
// A wait costs one system call and a look at each worker; an exchange of texts
// some 0.1 to 0.2 ms (decision 2). Forking is cheap as long as the process has
// little in memory and one thread, which is why the pool is made before the
// run.

#include "runtime/workers/worker_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace plsc {

namespace {

// One that kills a worker may have been unlucky (out of memory); one that
// kills two is to blame.
constexpr int kMaxDeaths = 2;

// The most that one wait counts, whatever the clock says: the rest is a time
// in which we were stopped or the machine slept.
constexpr double kLongestWait = 1;  // s
constexpr int kLongestPoll = 1000;  // ms, the same

// Parts of the limit after which a worker is looked at, so that it is kept to
// a quarter, and the longest time between looks.
constexpr double kLooks = 4;
constexpr double kLongestLook = 1;  // s

double Now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// What the socket takes now; false if nobody reads at the other end.
bool SendSome(int socket, const std::string& bytes, std::size_t& sent) {
  while (sent < bytes.size()) {
    // Without MSG_NOSIGNAL a dead receiver would end this process too.
    const ssize_t count = send(socket, bytes.data() + sent, bytes.size() - sent,
                               MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

/// What has come; false at the end of the stream.
bool ReceiveAll(int socket, FrameReader& reader) {
  char buffer[1 << 16];
  while (true) {
    const ssize_t count = recv(socket, buffer, sizeof buffer, MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    if (count == 0) return false;
    reader.Append({buffer, static_cast<std::size_t>(count)});
    if (reader.is_broken()) return true;
  }
}

}  // namespace

WorkerPool::WorkerPool(const WorkerPoolOptions& options, Work work)
    : options_(options), work_(std::move(work)) {
  assert(options.workers >= 1 && options.hang_seconds >= 0);
  for (int i = 0; i < options.workers; ++i)
    if (std::optional<Worker> worker = Start())
      workers_.push_back(std::move(*worker));
  // Fewer than asked for are still enough.
  if (!workers_.empty()) failure_.reset();
}

WorkerPool::~WorkerPool() {
  for (const Worker& worker : workers_) EndWorker(worker.process);
}

std::optional<WorkerPool::Worker> WorkerPool::Start() {
  const std::optional<WorkerProcess> process = StartWorker(work_);
  if (!process) {
    failure_ = fmt::format("cannot start a worker: {}", std::strerror(errno));
    return std::nullopt;
  }
  Worker worker;
  worker.process = *process;
  return worker;
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
    worker.unsent = Frame(worker.request->text);
    worker.sent = 0;
    worker.unwatched = 0;
    if (options_.hang_seconds > 0)
      worker.watch = WorkerWatch(ReadVitals(worker.process.pid));
    // If it is dead, Wait finds its socket closed and starts another one.
    SendSome(worker.process.socket, worker.unsent, worker.sent);
  }
}

std::vector<Reply> WorkerPool::Wait(int timeout_ms) {
  HandOut();  // what a death has put back
  std::vector<Reply> replies;
  if (outstanding() == 0 || failure_) return replies;
  const double begin = Now();
  std::vector<short> events;
  const bool has_events = Poll(timeout_ms, events);
  const double waited = std::min(Now() - begin, kLongestWait);
  for (std::size_t i = 0; i < workers_.size(); ++i) {
    std::optional<Reply> reply;
    if (has_events && events[i] != 0)
      reply = Attend(workers_[i], events[i]);
    else if (Hangs(workers_[i], waited))
      reply = Replace(workers_[i], fmt::format("no answer for {:g} s",
                                               options_.hang_seconds));
    if (reply) replies.push_back(std::move(*reply));
  }
  // Those that could not be replaced.
  std::erase_if(workers_,
                [](const Worker& worker) { return worker.process.pid == 0; });
  if (!workers_.empty()) failure_.reset();
  HandOut();
  return replies;
}

/// Whether anything happened at a worker's socket, and what.
bool WorkerPool::Poll(int timeout_ms, std::vector<short>& events) {
  std::vector<pollfd> polled;
  for (const Worker& worker : workers_) {
    const bool is_sent = worker.sent == worker.unsent.size();
    const int wanted = is_sent ? POLLIN : POLLIN | POLLOUT;
    polled.push_back({worker.process.socket, static_cast<short>(wanted), 0});
  }
  polled.push_back({wake_, POLLIN, 0});  // poll skips those below 0
  if (poll(polled.data(), polled.size(), std::min(timeout_ms, kLongestPoll)) <=
      0)
    return false;
  polled.pop_back();
  for (const pollfd& one : polled) events.push_back(one.revents);
  return true;
}

std::optional<Reply> WorkerPool::Attend(Worker& worker, short events) {
  const int socket = worker.process.socket;
  if ((events & POLLOUT) != 0) SendSome(socket, worker.unsent, worker.sent);
  if ((events & ~POLLOUT) == 0) return std::nullopt;
  const bool is_open = ReceiveAll(socket, worker.reader);
  if (std::optional<std::string> answer = worker.reader.Take();
      answer && worker.request)
    return TakeReply(worker, std::move(*answer));
  // Also one that answers without being asked.
  if (worker.reader.is_broken() || !worker.request)
    return Replace(worker, is_open ? "an answer that is none" : "");
  return is_open ? std::nullopt : Replace(worker, "");
}

Reply WorkerPool::TakeReply(Worker& worker, std::string answer) {
  Reply reply;
  reply.ticket = worker.request->ticket;
  reply.answer = std::move(answer);
  worker.request.reset();
  worker.unsent.clear();
  worker.sent = 0;
  return reply;
}

/// Looks at a worker now and then only, as that reads a file of the system.
bool WorkerPool::Hangs(Worker& worker, double waited) const {
  if (options_.hang_seconds <= 0 || !worker.request) return false;
  worker.unwatched += waited;
  const double pause = std::min(kLongestLook, options_.hang_seconds / kLooks);
  if (worker.unwatched < pause) return false;
  worker.watch.Add(worker.unwatched, ReadVitals(worker.process.pid));
  worker.unwatched = 0;
  return worker.watch.own_seconds() >= options_.hang_seconds;
}

/// Replaces a worker that died, or that must for `cause`. What it worked on is
/// begun again, once.
std::optional<Reply> WorkerPool::Replace(Worker& worker,
                                         const std::string& cause) {
  const std::string end = EndWorker(worker.process);
  std::optional<Reply> reply;
  if (worker.request && ++worker.request->deaths >= kMaxDeaths)
    reply = Reply{worker.request->ticket, std::nullopt,
                  cause.empty() ? end : cause};
  else if (worker.request)
    waiting_.push_front(std::move(*worker.request));
  worker = {};
  if (std::optional<Worker> successor = Start()) worker = std::move(*successor);
  return reply;
}

}  // namespace plsc
