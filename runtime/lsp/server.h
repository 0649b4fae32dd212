#pragma once

// The language server as a value: a message in, messages out. Knows no stream,
// no file and no clock; runtime/cli/commands/lsp.cc carries the bytes.
//
// Diagnostics come from Idle, not from Handle: who types faster than we compile
// sends several changes, and only the last of them is worth a look.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plsc::lsp {

/// The body to send when the bytes that come are no messages any more.
std::string BrokenBody(const std::string& why);

class Server {
 public:
  explicit Server(std::string version);
  ~Server();

  /// The body of one message. What is to be sent back, as bodies.
  std::vector<std::string> Handle(std::string_view body);
  /// Whether Idle has something to do.
  bool has_work() const;
  /// One piece of work that nobody waits for in order: diagnostics of a changed
  /// document first, then advice (Lint) on one genotype.
  std::vector<std::string> Idle();
  /// After `exit`: 0 when the client said `shutdown` before, else 1.
  std::optional<int> exit_status() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace plsc::lsp
