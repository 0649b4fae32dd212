#pragma once

// An HTTP server in one thread that its owner lends it piece by piece (Step),
// so that it can do other things between: wait for workers, look at a file.
// Nothing that a client does, or does not do, blocks it.

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/server/guard.h"
#include "runtime/server/message.h"

namespace plsc::server {

struct Limits {
  /// B of a request's body: a genotype has kilobytes, files that commands read
  /// at most 16 MiB, and a request may have two of them.
  std::size_t body = std::size_t{34} << 20U;
  std::size_t header = std::size_t{16} << 10U;  ///< B
  /// Connections at once. A browser makes 6. Beyond, the oldest of those that
  /// have never known the token is closed, or the new one if all have.
  std::size_t connections = 64;
  /// For a request to come whole, a response to be taken, the next request.
  std::chrono::milliseconds patience{10000};
};

class HttpServer {
 public:
  /// To be called once, from the thread that steps, then or later.
  using Respond = std::function<void(Response)>;
  /// `request` has passed the guard. `is_wanted` is false once its client has
  /// gone.
  using Handler = std::function<void(Request request, Respond respond,
                                     std::function<bool()> is_wanted)>;

  /// Listens at `port` of `address` (a number, as "127.0.0.1" or "::1"); 0: one
  /// that is free.
  static Expected<std::unique_ptr<HttpServer>, Failure> Listen(
      const std::string& address, int port, const Limits& limits = {});
  virtual ~HttpServer() = default;  ///< closes all connections
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  virtual int port() const = 0;
  /// Before the first step.
  virtual void Serve(Guard guard, Handler handler) = 0;
  /// Does what is to be done; where that is nothing, waits at most `wait`.
  virtual void Step(std::chrono::milliseconds wait) = 0;
  /// To all that listen for events. Who has not taken the last one of this name
  /// yet gets this one in its place: what counts is how things are.
  /// `data` must be one line.
  virtual void Publish(std::string_view name, std::string_view data) = 0;
  /// Those that listen for events.
  virtual std::size_t listeners() const = 0;
  virtual std::size_t connections() const = 0;

 protected:
  HttpServer() = default;
};

}  // namespace plsc::server
