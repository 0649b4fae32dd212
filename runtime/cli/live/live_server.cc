#include "runtime/cli/live/live_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace plsc::cli {

namespace {

using server::Refusal;
using server::Request;
using server::Response;

// What another editor saves is to be seen within 300 ms, in which the page also
// lives the robot; files are looked at in microseconds.
constexpr std::chrono::milliseconds kBetweenLooks{50};
// While answers are being computed the sockets of their processes and those of
// the page are looked at in turn, as no system call of ours waits for both.
constexpr std::chrono::milliseconds kBusyWait{1};
constexpr std::chrono::milliseconds kIdleWait{25};

bool IsLoopback(const std::string& host) {
  return host == "127.0.0.1" || host == "::1";
}

std::string Bracketed(const std::string& host) {
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

}  // namespace

LiveServer::LiveServer(const LiveOptions& options,
                       std::unique_ptr<Subject> subject,
                       const std::function<Work()>& make_work)
    : subject_(std::move(subject)), asker_(options.asker, make_work) {}

Expected<std::unique_ptr<LiveServer>, Failure> LiveServer::Begin(
    const LiveOptions& options, std::unique_ptr<Subject> subject,
    const std::function<Work()>& make_work,
    std::function<std::string(const std::string&, const std::string&)> page) {
  std::unique_ptr<LiveServer> live(
      new LiveServer(options, std::move(subject), make_work));
  live->page_ = std::move(page);
  live->host_ = options.host;
  live->token_ = server::RandomToken();
  if (live->token_.empty())
    return Failure("the system has no random numbers to make an address of");
  auto listening =
      server::HttpServer::Listen(options.host, options.port, options.limits);
  if (!listening) return listening.error();
  live->server_ = std::move(*listening);
  std::vector<std::string> hosts;
  // Reached from elsewhere it has names that we do not know.
  if (IsLoopback(options.host)) hosts = {Bracketed(options.host), "localhost"};
  live->server_->Serve(
      server::Guard(live->token_, std::move(hosts), live->server_->port()),
      [raw = live.get()](Request request, server::HttpServer::Respond respond,
                         std::function<bool()> is_wanted) {
        raw->Handle(std::move(request), std::move(respond),
                    std::move(is_wanted));
      });
  live->looked_ = live->open_ = std::chrono::steady_clock::now();
  return live;
}

std::string LiveServer::address() const {
  return fmt::format("http://{}:{}/{}/", Bracketed(host_), server_->port(),
                     token_);
}

bool LiveServer::is_private() const {
  return IsLoopback(host_);
}

void LiveServer::Handle(Request request, server::HttpServer::Respond respond,
                        std::function<bool()> is_wanted) {
  const std::string& target = request.target;
  const char* method = target == "ask" ? "POST" : "GET";
  const bool is_ours = target.empty() || target == "ask" || target == "events";
  if (is_ours && request.method != method)
    return respond(Refusal(405, fmt::format("this is to {}", method)));
  if (target == "ask") {
    asker_.Ask(std::move(request.body), std::move(respond),
               std::move(is_wanted));
    is_busy_ = asker_.Step();
    return;
  }
  if (target.empty())
    return respond({200, "text/html; charset=utf-8",
                    page_(subject_->Title(), subject_->PageData()), false});
  if (target != "events") return respond(subject_->Answer(request));
  Response events{200, "text/event-stream", "", true};
  for (const auto& [name, data] : subject_->Standing())
    events.body += fmt::format("event: {}\ndata: {}\n\n", name, data);
  respond(std::move(events));
}

std::chrono::duration<double> LiveServer::Idle() const {
  return std::chrono::steady_clock::now() - open_;
}

void LiveServer::Look() {
  const auto now = std::chrono::steady_clock::now();
  if (server_->listeners() > 0) open_ = now;
  if (now - looked_ < kBetweenLooks) return;
  looked_ = now;
  for (const auto& [name, data] : subject_->Look())
    server_->Publish(name, data);
}

void LiveServer::Step() {
  server_->Step(is_busy_ ? kBusyWait : kIdleWait);
  is_busy_ = asker_.Step();
  Look();
}

}  // namespace plsc::cli
