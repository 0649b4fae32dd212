// Sessions, one a connection, each in one of four states that its pending
// operation names: reading a header, reading a body, waiting for the handler,
// writing (or listening for events). A session keeps itself alive through the
// handlers of its operations (shared_from_this); closing its socket ends them.
//
// The guard is asked when the header is there, before a byte of the body is
// taken: strangers can make us hold a header's length each, no more. Who never
// showed the token is the first to go when there are too many.
//
// While a handler works, nothing is read; the socket is only watched for its
// end, so that what nobody waits for any more need not be computed.

#include "runtime/server/http_server.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <list>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace plsc::server {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;
using boost::system::error_code;

// So that a proxy or a browser does not take a silent stream for a dead one,
// and that a dead one is found.
constexpr std::chrono::seconds kPing{15};

class Session;
using Sessions = std::list<std::shared_ptr<Session>>;

/// What sessions know of their server.
struct Shared {
  Limits limits;
  std::optional<Guard> guard;
  HttpServer::Handler handler;
  Sessions sessions;
};

class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, Shared& shared)
      : stream_(std::move(socket)), shared_(shared) {}

  void Read() {
    parser_.emplace();
    parser_->body_limit(shared_.limits.body);
    parser_->header_limit(static_cast<std::uint32_t>(shared_.limits.header));
    stream_.expires_after(shared_.limits.patience);
    http::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](error_code error, std::size_t) {
          self->OnHeader(error);
        });
  }

  void Publish(const std::string& name, std::string_view data) {
    if (!is_listening_) return;
    std::string& event = pending_[name];
    event = "event: " + name + "\ndata: ";
    event.append(data);
    event += "\n\n";
    WriteEvents();
  }
  void Ping() {
    if (is_listening_ && pending_.empty()) {
      pending_[""] = ":\n\n";
      WriteEvents();
    }
  }

  void Close() {
    is_open_ = false;
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_both, ignored);
    stream_.close();
  }
  bool is_listening() const { return is_listening_; }
  bool is_known() const { return is_known_; }
  bool is_open() const { return is_open_; }

 private:
  void OnHeader(error_code error) {
    if (error) return OnBroken(error);
    const auto& header = parser_->get();
    request_ = {};
    request_.method = std::string(header.method_string());
    const std::string target(header.target());
    const std::size_t mark = target.find('?');
    request_.target = target.substr(0, mark);
    if (mark != std::string::npos) request_.query = target.substr(mark + 1);
    request_.host = std::string(header[http::field::host]);
    request_.origin = std::string(header[http::field::origin]);
    if (auto refusal = shared_.guard->Refuse(request_)) {
      is_last_ = true;
      return Write(std::move(*refusal));
    }
    is_known_ = true;
    http::async_read(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](error_code failed, std::size_t) {
          self->OnRequest(failed);
        });
  }

  void OnBroken(error_code error) {
    if (error == http::error::body_limit)
      return Refuse(413, "this is more than a request may have");
    if (error == http::error::header_limit)
      return Refuse(431, "this header is longer than a request's may be");
    // Time that has run out, and ends of connections, are no errors of HTTP.
    if (error.category() ==
            make_error_code(http::error::bad_version).category() &&
        error != http::error::end_of_stream &&
        error != http::error::partial_message)
      return Refuse(400, "this is no request of HTTP");
    Leave();
  }
  void Refuse(int status, const char* words) {
    is_last_ = true;
    Write(Refusal(status, words));
  }

  void OnRequest(error_code error) {
    if (error) return OnBroken(error);
    request_.body = std::move(parser_->get().body());
    is_last_ = !parser_->keep_alive();
    stream_.expires_never();
    is_answered_ = false;
    Watch();
    shared_.handler(
        std::move(request_),
        [weak = weak_from_this()](Response response) {
          if (const auto self = weak.lock(); self && self->is_open_)
            self->OnResponse(std::move(response));
        },
        [weak = weak_from_this()] {
          const auto self = weak.lock();
          return self && self->is_open_;
        });
  }

  /// Finds that the other end has gone, while we have nothing to say.
  void Watch() {
    stream_.socket().async_wait(
        tcp::socket::wait_read, [self = shared_from_this()](error_code error) {
          if (error || self->is_answered_ || !self->is_open_) return;
          char byte = 0;
          error_code failed;
          self->stream_.socket().receive(asio::buffer(&byte, 1),
                                         tcp::socket::message_peek, failed);
          // The next request may come before the answer to this one.
          if (failed) self->Leave();
        });
  }

  void OnResponse(Response response) {
    is_answered_ = true;
    stream_.socket().cancel();  // what watches
    if (response.is_events) return Listen(std::move(response));
    Write(std::move(response));
  }

  template <typename Message>
  void Describe(const Response& response, Message& message) const {
    message.result(static_cast<unsigned>(response.status));
    message.set(http::field::server, "plsc");
    message.set(http::field::content_type, response.type);
    message.set(http::field::cache_control, "no-store");
    message.set("X-Content-Type-Options", "nosniff");
    message.set("Referrer-Policy", "no-referrer");
    message.set("Cross-Origin-Resource-Policy", "same-origin");
    message.set("Cross-Origin-Opener-Policy", "same-origin");
    message.set("X-Frame-Options", "DENY");
  }

  void Write(Response response) {
    written_.emplace();
    Describe(response, *written_);
    written_->body() = std::move(response.body);
    written_->keep_alive(!is_last_);
    written_->prepare_payload();
    stream_.expires_after(shared_.limits.patience);
    http::async_write(
        stream_, *written_,
        [self = shared_from_this()](error_code error, std::size_t) {
          self->written_.reset();
          if (error || self->is_last_) return self->Leave();
          self->Read();
        });
  }

  void Listen(Response response) {
    http::response<http::empty_body> header;
    response.type = "text/event-stream";
    Describe(response, header);
    header.keep_alive(false);
    std::ostringstream text;
    text << header.base();
    sent_ = std::move(text).str() + response.body;
    is_listening_ = true;
    is_writing_ = true;
    Send();
    Watch();
    is_answered_ = false;
  }

  void WriteEvents() {
    if (is_writing_ || pending_.empty()) return;
    sent_.clear();
    for (const auto& [name, event] : pending_) sent_ += event;
    pending_.clear();
    is_writing_ = true;
    Send();
  }
  void Send() {
    stream_.expires_after(shared_.limits.patience);
    asio::async_write(
        stream_, asio::buffer(sent_),
        [self = shared_from_this()](error_code error, std::size_t) {
          self->is_writing_ = false;
          if (error) return self->Leave();
          self->stream_.expires_never();
          self->WriteEvents();
        });
  }

  void Leave() {
    Close();
    is_listening_ = false;
    shared_.sessions.remove(shared_from_this());
  }

  beast::tcp_stream stream_;
  Shared& shared_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Request request_;
  std::optional<http::response<http::string_body>> written_;
  bool is_open_ = true;
  bool is_known_ = false;  // has shown the token
  bool is_last_ = false;   // closed after this answer
  bool is_answered_ = false;
  bool is_listening_ = false;
  bool is_writing_ = false;
  std::string sent_;                            // what is being written
  std::map<std::string, std::string> pending_;  // by name, what will be
};

class BeastServer : public HttpServer {
 public:
  explicit BeastServer(const Limits& limits) { shared_.limits = limits; }
  // What is polled here finds that its connection has ended, and throws
  // nothing.
  ~BeastServer() override {  // NOLINT(bugprone-exception-escape)
    for (const auto& session : shared_.sessions) session->Close();
    error_code ignored;
    acceptor_.close(ignored);
    ping_.cancel();
    // The operations that were pending end, and with them the sessions.
    shared_.handler = nullptr;
    io_.restart();
    io_.poll();
    shared_.sessions.clear();
  }

  error_code Bind(const std::string& address, int port) {
    error_code error;
    const auto ip = asio::ip::make_address(address, error);
    if (error) return error;
    const tcp::endpoint end(ip, static_cast<unsigned short>(port));
    if (acceptor_.open(end.protocol(), error)) return error;
    // Or a server could not begin again for a minute after one has ended.
    if (acceptor_.set_option(asio::socket_base::reuse_address(true), error))
      return error;
    if (acceptor_.bind(end, error)) return error;
    acceptor_.listen(asio::socket_base::max_listen_connections, error);
    return error;
  }

  int port() const override { return acceptor_.local_endpoint().port(); }

  void Serve(Guard guard, Handler handler) override {
    shared_.guard = std::move(guard);
    shared_.handler = std::move(handler);
    Accept();
    Ping();
  }

  void Step(std::chrono::milliseconds wait) override {
    io_.restart();
    io_.run_one_for(wait);
    io_.poll();
  }

  void Publish(std::string_view name, std::string_view data) override {
    const std::string key(name);
    for (const auto& session : shared_.sessions) session->Publish(key, data);
  }

  std::size_t listeners() const override {
    std::size_t count = 0;
    for (const auto& session : shared_.sessions)
      count += session->is_listening() ? 1 : 0;
    return count;
  }
  std::size_t connections() const override { return shared_.sessions.size(); }

 private:
  void Accept() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (!acceptor_.is_open()) return;
      if (error == asio::error::operation_aborted) return;
      if (!error) Welcome(std::move(socket));
      if (!error) return Accept();
      // No descriptors are left, say: others will be closed.
      pause_.expires_after(std::chrono::milliseconds(100));
      pause_.async_wait([this](error_code ended) {
        if (!ended) Accept();
      });
    });
  }

  void Welcome(tcp::socket socket) {
    if (shared_.sessions.size() >= shared_.limits.connections) {
      const auto stranger =
          std::find_if(shared_.sessions.begin(), shared_.sessions.end(),
                       [](const auto& one) { return !one->is_known(); });
      if (stranger == shared_.sessions.end()) return;  // closes the socket
      (*stranger)->Close();
      shared_.sessions.erase(stranger);
    }
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    shared_.sessions.push_back(
        std::make_shared<Session>(std::move(socket), shared_));
    shared_.sessions.back()->Read();
  }

  void Ping() {
    ping_.expires_after(kPing);
    ping_.async_wait([this](error_code ended) {
      if (ended) return;
      for (const auto& session : shared_.sessions) session->Ping();
      Ping();
    });
  }

  asio::io_context io_{1};
  Shared shared_;
  tcp::acceptor acceptor_{io_};
  asio::steady_timer pause_{io_};
  asio::steady_timer ping_{io_};
};

}  // namespace

Expected<std::unique_ptr<HttpServer>, Failure> HttpServer::Listen(
    const std::string& address, int port, const Limits& limits) {
  error_code no_address;
  asio::ip::make_address(address, no_address);
  if (no_address)
    return Failure("'" + address +
                   "' is no address to listen at: these are numbers, as "
                   "127.0.0.1 or ::1");
  auto server = std::make_unique<BeastServer>(limits);
  if (const error_code error = server->Bind(address, port))
    return Failure("cannot listen at port " + std::to_string(port) + " of " +
                   address + ": " + error.message());
  return std::unique_ptr<HttpServer>(std::move(server));
}

}  // namespace plsc::server
