// A relay between MPI and a pool. It never has more requests in its pool than
// there are workers, so that those that wait can be taken back (kCancel); what
// it cannot do any more it says, and rank 0 gives what it had to others.
// Nothing waits inside MPI: it looks for messages, waits for its workers'
// sockets in between, and longer each time that nothing comes.

#include "runtime/workers/mpi_server.h"

#include <poll.h>

#include <cassert>
#include <cstring>

#include "runtime/workers/mpi_pause.h"

namespace plsc {

void RankServer::Serve() {
  MpiPause pause;
  bool is_active = true;
  while (true) {
    const int patience = link_.is_sending() ? 0 : pause.Next(is_active);
    is_active = false;
    while (const auto message = link_.Receive()) {
      is_active = true;
      if (!Obey(Decode(message->text))) return;
    }
    HandOut();
    is_active |= Answer(is_active ? 0 : patience);
    ReportWorkers();
  }
}

/// False at the end.
bool RankServer::Obey(RankWords words) {
  switch (words.word) {
    case RankWord::kBegin: {
      double seconds = 0;
      assert(words.text.size() == sizeof seconds);
      std::memcpy(&seconds, words.text.data(), sizeof seconds);
      pool_.SetHangSeconds(seconds);
      reported_workers_ = pool_.workers();
      Send(RankWord::kHello, reported_workers_, ProgramVersion());
      return true;
    }
    case RankWord::kWork:
      waiting_.emplace_back(words.number, std::move(words.text));
      return true;
    case RankWord::kCancel:
      for (const auto& [ticket, request] : waiting_)
        Send(RankWord::kCancelled, ticket);
      waiting_.clear();
      Send(RankWord::kAllCancelled);
      return true;
    case RankWord::kEnd:
      Send(RankWord::kBye);
      return false;
    default:
      assert(false);  // words that are said to rank 0
      return false;
  }
}

void RankServer::HandOut() {
  while (!has_failed_ && !waiting_.empty() &&
         pool_.outstanding() < pool_.workers()) {
    pool_.Submit(waiting_.front().first, std::move(waiting_.front().second));
    waiting_.pop_front();
  }
}

/// Waits for answers; whether there were any.
bool RankServer::Answer(int patience_ms) {
  if (has_failed_ || pool_.outstanding() == 0) {
    poll(nullptr, 0, patience_ms);
    return false;
  }
  const std::vector<Reply> replies = pool_.Wait(patience_ms);
  for (const Reply& reply : replies) {
    if (reply.answer)
      Send(RankWord::kAnswer, reply.ticket, *reply.answer);
    else
      Send(RankWord::kDeath, reply.ticket, reply.death);
  }
  return !replies.empty();
}

void RankServer::ReportWorkers() {
  if (pool_.failure() && !has_failed_) {
    has_failed_ = true;
    // Rank 0 gives what we had to others.
    waiting_.clear();
    Send(RankWord::kFailure, 0, *pool_.failure());
  } else if (pool_.workers() != reported_workers_) {
    reported_workers_ = pool_.workers();
    Send(RankWord::kWorkers, reported_workers_);
  }
}

void RankServer::Send(RankWord word, int number, std::string text) {
  link_.Send(0, Encode({word, number, std::move(text)}));
}

}  // namespace plsc
