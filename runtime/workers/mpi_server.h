#pragma once

// A rank that lends its workers to rank 0: relays requests to the pool and
// answers back. Keeps requests that wait for a worker itself, so that they can
// be taken back.

#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "runtime/workers/mpi_link.h"
#include "runtime/workers/mpi_message.h"
#include "runtime/workers/worker_pool.h"

namespace plsc {

class RankServer {
 public:
  RankServer(RankLink& link, WorkerPool& pool) : link_(link), pool_(pool) {}

  /// Until rank 0 is at its end.
  void Serve();

 private:
  bool Obey(RankWords words);
  void HandOut();
  bool Answer(int patience_ms);
  void ReportWorkers();
  void Send(RankWord word, int number = 0, std::string text = "");

  RankLink& link_;
  WorkerPool& pool_;
  std::deque<std::pair<int, std::string>> waiting_;  // ticket and request
  int reported_workers_ = 0;
  bool has_failed_ = false;
};

}  // namespace plsc
