#pragma once

// Requests and responses of HTTP as their handlers see them.

#include <string>
#include <utility>
#include <vector>

namespace plsc::server {

struct Request {
  std::string method;  ///< "GET", "POST"
  std::string target;  ///< as sent: "/TOKEN/ask"; of the guard's: "ask"
  std::string query;   ///< behind '?', as sent
  std::string host;    ///< of the header Host
  std::string origin;  ///< of the header Origin; empty: there was none
  std::string body;
};

struct Response {
  int status = 200;
  std::string type = "application/json";  ///< Content-Type
  std::string body;
  /// Stays open and gets what HttpServer::Publish sends; `body` comes first.
  bool is_events = false;
};

/// One line of words, for people who look at a refusal.
inline Response Refusal(int status, std::string words) {
  words += '\n';
  return {status, "text/plain; charset=utf-8", std::move(words), false};
}

}  // namespace plsc::server
