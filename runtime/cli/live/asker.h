#pragma once

// A page's questions, answered by processes of their own (WorkerPool), so that
// a robot that crashes or never ends takes nobody along: whoever asked is told,
// and the next question finds another process.
//
// Two kinds, which must not wait for each other: what editing asks (check,
// complete, hover) takes milliseconds and shares one memory, that of the
// language server, so one process answers all of it in order; what lives takes
// longer, remembers nothing, and has several.

#include <deque>
#include <functional>
#include <map>
#include <string>

#include "runtime/server/http_server.h"
#include "runtime/workers/worker_pool.h"

namespace plsc::cli {

struct AskerOptions {
  int lives = 2;  ///< processes
  /// s of its own that a process may take for one answer.
  double patience = 20;
};

class Asker {
 public:
  /// Forks: from the only thread. `make_work` is called once a process.
  Asker(const AskerOptions& options, const std::function<Work()>& make_work);

  /// `question`: JSON (docs/service.md). Who is not wanted any more when its
  /// turn comes is never begun.
  void Ask(std::string question, server::HttpServer::Respond respond,
           std::function<bool()> is_wanted);
  /// Hands out answers that are there. Whether questions are open.
  bool Step();

 private:
  struct Question {
    std::string text;
    server::HttpServer::Respond respond;
    std::function<bool()> is_wanted;
  };
  struct Desk {
    WorkerPool pool;
    std::deque<Question> waiting;
    std::map<int, Question> begun;  // by ticket

    bool Step(int& tickets);
  };

  Desk editing_;
  Desk lives_;
  int tickets_ = 0;
};

}  // namespace plsc::cli
