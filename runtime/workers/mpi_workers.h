#pragma once

// The workers of all ranks, as the run on rank 0 sees them: its own pool and
// those of the ranks that RankServer serves. Which of them gets a request
// changes no answer, so no result either.

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/workers/mpi_link.h"
#include "runtime/workers/mpi_message.h"
#include "runtime/workers/worker_pool.h"
#include "runtime/workers/workers.h"

namespace plsc {

class MpiWorkers : public Workers {
 public:
  /// Waits until each rank has said hello. `own` answers requests with a
  /// setup (worker_setup.h), as the other ranks' pools do.
  MpiWorkers(RankLink& link, WorkerPool& own, std::string setup,
             double hang_seconds);

  void Submit(int ticket, std::string request) override;
  void CancelWaiting() override;
  std::vector<Reply> Wait(int timeout_ms) override;

  int workers() const override;
  int busy() const override;
  int outstanding() const override;
  const std::optional<std::string>& failure() const override {
    return failure_;
  }

 private:
  struct Rank {
    int workers = 0;
    bool is_there = false;  // has said hello
    bool is_cancelling = false;
    /// What it has not answered, by ticket; kept for the case that it fails.
    std::map<int, std::string> requests;

    int load() const { return static_cast<int>(requests.size()); }
  };

  void HandOut();
  std::optional<std::size_t> ChooseRank() const;
  void Give(std::size_t rank, int ticket, std::string request);
  bool ReceiveAll(std::vector<Reply>& replies);
  void Handle(std::size_t rank, RankWords words, std::vector<Reply>& replies);
  void Greet(std::size_t rank, const RankWords& hello);
  void Fail(std::size_t rank, const std::string& reason);
  bool WaitForOwn(int patience_ms, std::vector<Reply>& replies);

  RankLink& link_;
  WorkerPool& own_;
  std::string setup_;
  std::vector<Rank> ranks_;                          // by rank; [0] is own_
  std::deque<std::pair<int, std::string>> waiting_;  // ticket and request
  std::optional<std::string> failure_;
};

}  // namespace plsc
