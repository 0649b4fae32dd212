#include "runtime/server/http_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace plsc::server {
namespace {

/// A client that does only what it is told. Never waits.
class Client {
 public:
  explicit Client(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) ==
            0);
  }
  ~Client() { Close(); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void Send(const std::string& text) const {
    std::size_t sent = 0;
    while (sent < text.size()) {
      const ssize_t count =
          ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }
  /// Takes what has come.
  const std::string& Taken() {
    char buffer[1 << 16];
    while (true) {
      const ssize_t count =
          ::recv(socket_, buffer, sizeof buffer, MSG_DONTWAIT);
      if (count == 0) is_over_ = true;
      if (count < 0 && errno == ECONNRESET) is_over_ = true;
      if (count <= 0) return taken_;
      taken_.append(buffer, static_cast<std::size_t>(count));
    }
  }
  /// The other end has closed it.
  bool IsOver() {
    Taken();
    return is_over_;
  }
  void Close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }

 private:
  int socket_;
  std::string taken_;
  bool is_over_ = false;
};

struct Served {
  explicit Served(const Limits& limits = {}) {
    auto listening = HttpServer::Listen("127.0.0.1", 0, limits);
    REQUIRE(listening);
    server = std::move(*listening);
    port = server->port();
    server->Serve(
        Guard("t", {"127.0.0.1"}, port),
        [this](Request request, HttpServer::Respond respond,
               std::function<bool()> wanted) {
          requests.push_back(request);
          is_wanted = std::move(wanted);
          if (request.target == "later") {
            later = std::move(respond);
          } else if (request.target == "events") {
            respond({200, "text/event-stream", "event: a\ndata: 0\n\n", true});
          } else {
            respond({200, "text/plain", "you said " + request.body, false});
          }
        });
  }

  /// Steps until it is so; fails if it never is.
  void Until(const std::function<bool()>& is_so) {
    for (int i = 0; i < 20000 && !is_so(); ++i)
      server->Step(std::chrono::milliseconds(1));
    CHECK(is_so());
  }

  std::string Head(const std::string& first) const {
    return first + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
           "\r\n";
  }
  std::string Post(const std::string& target, const std::string& body) const {
    return Head("POST /t/" + target) +
           "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  }

  std::unique_ptr<HttpServer> server;
  int port = 0;
  std::vector<Request> requests;
  HttpServer::Respond later;
  std::function<bool()> is_wanted;
};

bool Has(Client& client, const std::string& text) {
  return client.Taken().find(text) != std::string::npos;
}

TEST_CASE("requests are answered, one after another on a connection",
          "[http_server]") {
  Served served;
  Client client(served.port);
  client.Send(served.Post("x?a=1", "one") + served.Post("y", "two"));
  served.Until([&] { return Has(client, "you said two"); });
  CHECK(Has(client, "you said one"));
  CHECK(Has(client, "Cache-Control: no-store"));
  CHECK(Has(client, "Referrer-Policy: no-referrer"));
  CHECK(Has(client, "X-Content-Type-Options: nosniff"));
  REQUIRE(served.requests.size() == 2);
  CHECK(served.requests[0].target == "x");
  CHECK(served.requests[0].query == "a=1");
  CHECK(served.requests[1].target == "y");
  CHECK_FALSE(client.IsOver());
}

TEST_CASE("a request may come byte by byte", "[http_server]") {
  Served served;
  Client client(served.port);
  for (const char c : served.Post("x", "slowly")) {
    client.Send(std::string(1, c));
    served.server->Step(std::chrono::milliseconds(0));
  }
  served.Until([&] { return Has(client, "you said slowly"); });
}

TEST_CASE("strangers are refused before their body is taken", "[http_server]") {
  Served served;
  Client client(served.port);
  client.Send(served.Head("POST /wrong/ask") +
              "Content-Length: 30000000\r\n\r\n");
  served.Until([&] { return client.IsOver(); });
  CHECK(Has(client, "403"));
  CHECK(served.requests.empty());
}

TEST_CASE("what is too much, or no HTTP, gets a word and the door",
          "[http_server]") {
  Limits limits;
  limits.body = 1000;
  limits.header = 2000;
  Served served(limits);
  const auto [sent, status] = GENERATE_REF(
      std::pair(served.Post("x", std::string(1001, 'b')), "413"),
      std::pair(served.Head("GET /t/") + "A: " + std::string(3000, 'a'), "431"),
      std::pair(std::string("nonsense\r\n\r\n"), "400"),
      std::pair(std::string(5000, '\0'), "4"),
      std::pair(std::string("GET / HTTP/9.9\r\n\r\n"), "400"));
  Client client(served.port);
  client.Send(sent);
  served.Until([&] { return client.IsOver(); });
  CHECK(client.Taken().substr(0, 9 + std::string(status).size()) ==
        std::string("HTTP/1.1 ") + status);
  CHECK(served.requests.empty());
  // Others are served.
  Client next(served.port);
  next.Send(served.Post("x", "still"));
  served.Until([&] { return Has(next, "you said still"); });
}

TEST_CASE("who says nothing, or half, is shown out in time", "[http_server]") {
  Limits limits;
  limits.patience = std::chrono::milliseconds(30);
  Served served(limits);
  Client silent(served.port);
  Client half(served.port);
  half.Send(served.Head("POST /t/x") + "Content-Length: 100\r\n\r\nabc");
  served.Until([&] { return silent.IsOver() && half.IsOver(); });
  CHECK(served.server->connections() == 0);
}

TEST_CASE("strangers in any number do not keep the known out",
          "[http_server]") {
  Limits limits;
  limits.connections = 8;
  Served served(limits);
  Client known(served.port);
  known.Send(served.Post("events", ""));
  served.Until([&] { return served.server->listeners() == 1; });
  std::vector<std::unique_ptr<Client>> strangers;
  for (int i = 0; i < 100; ++i) {
    strangers.push_back(std::make_unique<Client>(served.port));
    strangers.back()->Send("GET /");
    served.server->Step(std::chrono::milliseconds(0));
  }
  Client late(served.port);
  late.Send(served.Post("x", "me"));
  served.Until([&] { return Has(late, "you said me"); });
  CHECK(served.server->connections() <= 8);
  CHECK_FALSE(known.IsOver());
}

TEST_CASE("an answer may come later, or its asker may leave before",
          "[http_server]") {
  Served served;
  {
    Client client(served.port);
    client.Send(served.Post("later", ""));
    served.Until([&] { return served.later != nullptr; });
    CHECK(served.is_wanted());
    served.later({200, "text/plain", "at last", false});
    served.Until([&] { return Has(client, "at last"); });
    served.later = nullptr;
  }
  Client client(served.port);
  client.Send(served.Post("later", ""));
  served.Until([&] { return served.later != nullptr; });
  client.Close();
  served.Until([&] { return !served.is_wanted(); });
  served.later({200, "text/plain", "to nobody", false});
  served.server->Step(std::chrono::milliseconds(0));
}

TEST_CASE("events reach all who listen; only the newest waits",
          "[http_server]") {
  Served served;
  Client first(served.port);
  Client second(served.port);
  first.Send(served.Head("GET /t/events") + "\r\n");
  second.Send(served.Head("GET /t/events") + "\r\n");
  served.Until([&] { return served.server->listeners() == 2; });
  served.Until([&] { return Has(first, "data: 0") && Has(second, "data: 0"); });
  // Too much for a socket's buffer: what is published while it is written
  // takes the place of what waits.
  const std::string big(std::size_t{8} << 20U, 'x');
  served.server->Publish("big", big);
  for (int i = 1; i <= 1000; ++i)
    served.server->Publish("a", "number " + std::to_string(i));
  served.Until([&] { return Has(first, "number 1000\n\n"); });
  CHECK_FALSE(Has(first, "number 999\n"));
  second.Close();
  served.Until([&] {
    served.server->Publish("a", "again");
    return served.server->listeners() == 1;
  });
}

TEST_CASE("a port that is taken is a failure with the reason",
          "[http_server]") {
  Served served;
  const auto again = HttpServer::Listen("127.0.0.1", served.port);
  REQUIRE_FALSE(again);
  CHECK(again.error().text.find("Address already in use") != std::string::npos);
  CHECK_FALSE(HttpServer::Listen("localhost.", 0));
  CHECK_FALSE(HttpServer::Listen("203.0.113.1", 0));
}

}  // namespace
}  // namespace plsc::server
