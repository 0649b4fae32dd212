// The pools of all ranks behind the one interface of Workers (decision 11). A
// request is at any time in exactly one place: in `waiting_`, or among the
// requests of the rank that has it, with its text, so that it can be given to
// another if that rank has no workers any more. It goes to whoever has most
// idle workers; which one that is depends on the clock, so nothing of the
// answer may.
//
// MPI's own waiting keeps a core busy, and the core belongs to a worker. So
// nothing here waits inside MPI: messages are looked for between looks at our
// own pool, with pauses that grow while nothing comes (mpi_pause). While
// something is still being sent there is no pause, as MPI moves long messages
// on only when it is called.
//
// Each other rank may have one request a worker in advance, which hides the way
// there and back, but only while more wait than there are workers: towards the
// end of a generation a request that waits behind a long simulation would hold
// up all.
//
// A request waits for a look at its message, 10 ms at most (mpi_pause), on
// either end of its way, beside simulations that take a second.

#include "runtime/workers/mpi_workers.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cassert>
#include <chrono>

#include "runtime/workers/mpi_pause.h"
#include "runtime/workers/worker_setup.h"

namespace plsc {

namespace {

using Clock = std::chrono::steady_clock;

std::string BytesOf(double number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

int MillisecondsTo(Clock::time_point end) {
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
  return std::max(0, static_cast<int>(left.count()));
}

}  // namespace

MpiWorkers::MpiWorkers(RankLink& link, WorkerPool& own, std::string setup,
                       double hang_seconds)
    : link_(link), own_(own), setup_(std::move(setup)) {
  ranks_.resize(static_cast<std::size_t>(link.size()));
  own_.SetHangSeconds(hang_seconds);
  ranks_[0].is_there = true;
  ranks_[0].workers = own_.workers();
  for (int rank = 1; rank < link.size(); ++rank)
    link_.Send(rank, Encode({RankWord::kBegin, 0, BytesOf(hang_seconds)}));
  std::vector<Reply> none;
  MpiPause pause;
  while (!std::all_of(ranks_.begin(), ranks_.end(),
                      [](const Rank& rank) { return rank.is_there; }))
    if (!ReceiveAll(none)) poll(nullptr, 0, pause.Next(false));
  if (own_.failure()) Fail(0, *own_.failure());
}

int MpiWorkers::workers() const {
  int sum = 0;
  for (const Rank& rank : ranks_) sum += rank.workers;
  return sum;
}

int MpiWorkers::busy() const {
  int sum = 0;
  for (const Rank& rank : ranks_) sum += std::min(rank.load(), rank.workers);
  return sum;
}

int MpiWorkers::outstanding() const {
  auto sum = static_cast<int>(waiting_.size());
  for (const Rank& rank : ranks_) sum += rank.load();
  return sum;
}

void MpiWorkers::Submit(int ticket, std::string request) {
  waiting_.emplace_back(ticket, RequestWithSetup(setup_, request));
  HandOut();
}

void MpiWorkers::HandOut() {
  while (!waiting_.empty()) {
    const std::optional<std::size_t> rank = ChooseRank();
    if (!rank) return;
    auto [ticket, request] = std::move(waiting_.front());
    waiting_.pop_front();
    Give(*rank, ticket, std::move(request));
  }
}

/// Who gets the next request: whoever has most idle workers. When none is idle
/// and there is a lot to do, other ranks get one for each worker in advance, so
/// that workers need not wait for the way to us and back. Not towards the end
/// of a generation, where another worker would be free sooner.
std::optional<std::size_t> MpiWorkers::ChooseRank() const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < ranks_.size(); ++i)
    if (ranks_[i].workers - ranks_[i].load() >
        ranks_[best].workers - ranks_[best].load())
      best = i;
  if (ranks_[best].load() < ranks_[best].workers) return best;
  if (static_cast<int>(waiting_.size()) <= workers()) return std::nullopt;
  for (std::size_t i = 1; i < ranks_.size(); ++i)
    if (ranks_[i].load() < 2 * ranks_[i].workers) return i;
  return std::nullopt;
}

void MpiWorkers::Give(std::size_t rank, int ticket, std::string request) {
  ranks_[rank].requests[ticket] = request;
  if (rank == 0)
    own_.Submit(ticket, std::move(request));
  else
    link_.Send(static_cast<int>(rank),
               Encode({RankWord::kWork, ticket, std::move(request)}));
}

void MpiWorkers::CancelWaiting() {
  waiting_.clear();
  // Our own pool has nothing in advance (ChooseRank), so nothing to take back.
  for (std::size_t i = 1; i < ranks_.size(); ++i) {
    if (ranks_[i].is_cancelling || ranks_[i].load() <= ranks_[i].workers)
      continue;
    ranks_[i].is_cancelling = true;
    link_.Send(static_cast<int>(i), Encode({RankWord::kCancel, 0, ""}));
  }
}

std::vector<Reply> MpiWorkers::Wait(int timeout_ms) {
  const auto end = Clock::now() + std::chrono::milliseconds(timeout_ms);
  std::vector<Reply> replies;
  MpiPause pause;
  bool is_active = true;
  while (!failure_ && outstanding() > 0) {
    const int left = MillisecondsTo(end);
    const int patience =
        link_.is_sending() ? 0 : std::min(left, pause.Next(is_active));
    is_active = ReceiveAll(replies);
    HandOut();
    is_active |= WaitForOwn(replies.empty() ? patience : 0, replies);
    HandOut();
    if (!replies.empty() || left == 0) break;
  }
  return replies;
}

bool MpiWorkers::ReceiveAll(std::vector<Reply>& replies) {
  bool is_active = false;
  while (auto message = link_.Receive()) {
    is_active = true;
    Handle(static_cast<std::size_t>(message->rank), Decode(message->text),
           replies);
  }
  return is_active;
}

void MpiWorkers::Handle(std::size_t rank, RankWords words,
                        std::vector<Reply>& replies) {
  const int ticket = words.number;
  switch (words.word) {
    case RankWord::kHello:
      return Greet(rank, words);
    case RankWord::kWorkers:
      ranks_[rank].workers = words.number;
      return;
    case RankWord::kAnswer:
      ranks_[rank].requests.erase(ticket);
      replies.push_back({ticket, std::move(words.text), ""});
      return;
    case RankWord::kDeath:
      ranks_[rank].requests.erase(ticket);
      replies.push_back({ticket, std::nullopt, std::move(words.text)});
      return;
    case RankWord::kCancelled:
      ranks_[rank].requests.erase(ticket);
      return;
    case RankWord::kAllCancelled:
      ranks_[rank].is_cancelling = false;
      return;
    case RankWord::kFailure:
      return Fail(rank, words.text);
    default:
      assert(false);  // words that rank 0 says
  }
}

void MpiWorkers::Greet(std::size_t rank, const RankWords& hello) {
  ranks_[rank].is_there = true;
  ranks_[rank].workers = hello.number;
  if (hello.text != ProgramVersion())
    failure_ = fmt::format("rank {} runs {}, and rank 0 {}", rank, hello.text,
                           ProgramVersion());
}

/// A rank without workers; others do what it had.
void MpiWorkers::Fail(std::size_t rank, const std::string& reason) {
  for (auto& [ticket, request] : ranks_[rank].requests)
    waiting_.emplace_front(ticket, std::move(request));
  ranks_[rank].requests.clear();
  ranks_[rank].workers = 0;
  if (workers() == 0) failure_ = fmt::format("rank {}: {}", rank, reason);
}

/// Waits for this rank's own workers; whether they answered anything.
bool MpiWorkers::WaitForOwn(int patience_ms, std::vector<Reply>& replies) {
  if (own_.outstanding() == 0 || own_.failure()) {
    poll(nullptr, 0, patience_ms);
    return false;
  }
  std::vector<Reply> own = own_.Wait(patience_ms);
  for (Reply& reply : own) {
    ranks_[0].requests.erase(reply.ticket);
    replies.push_back(std::move(reply));
  }
  if (own_.failure())
    Fail(0, *own_.failure());
  else
    ranks_[0].workers = own_.workers();
  return !own.empty();
}

}  // namespace plsc
