#pragma once

// All that a page asks of plsc, as one value: a request in, an answer out, both
// one JSON object (docs/service.md). Knows no stream, no file, no clock and no
// thread. What it answers is a function of the request, but for the language
// server's documents.

#include <memory>
#include <string>
#include <string_view>

namespace plsc {

class Service {
 public:
  explicit Service(std::string version);
  ~Service();

  /// {"id", "ask", "ok": true, ...} or {"id", "ask", "ok": false, "error",
  /// "diagnostics"?}, on one line without its end. Of any bytes, without
  /// throwing.
  std::string Answer(std::string_view request);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace plsc
