#pragma once

// The page, its questions, its events: what `plsc live` serves, put together.
// One thread; whoever owns it steps.

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "runtime/cli/live/asker.h"
#include "runtime/cli/live/subject.h"
#include "runtime/server/http_server.h"

namespace plsc::cli {

struct LiveOptions {
  std::string host = "127.0.0.1";  ///< where to listen, a number
  int port = 0;                    ///< 0: one that is free
  AskerOptions asker;
  server::Limits limits;
};

class LiveServer {
 public:
  /// Forks: from the only thread. `page` makes HTML of a title and data.
  static Expected<std::unique_ptr<LiveServer>, Failure> Begin(
      const LiveOptions& options, std::unique_ptr<Subject> subject,
      const std::function<Work()>& make_work,
      std::function<std::string(const std::string&, const std::string&)> page);

  /// What to open, with the token.
  std::string address() const;
  /// Whether no other machine reaches it.
  bool is_private() const;
  /// Since a page was open last, or since the beginning.
  std::chrono::duration<double> Idle() const;
  /// Does what is to be done, at most some 25 ms if that is nothing.
  void Step();

  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

 private:
  LiveServer(const LiveOptions& options, std::unique_ptr<Subject> subject,
             const std::function<Work()>& make_work);

  void Handle(server::Request request, server::HttpServer::Respond respond,
              std::function<bool()> is_wanted);
  void Look();

  std::unique_ptr<Subject> subject_;
  Asker asker_;  // before the server: forked without its socket
  std::unique_ptr<server::HttpServer> server_;
  std::function<std::string(const std::string&, const std::string&)> page_;
  std::string host_;
  std::string token_;
  bool is_busy_ = false;
  std::chrono::steady_clock::time_point looked_;
  std::chrono::steady_clock::time_point open_;  // when a page was, last
};

}  // namespace plsc::cli
