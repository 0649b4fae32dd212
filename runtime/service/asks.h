#pragma once

// What the service can be asked: a function an ask, in one table. Each is a
// function of the request alone; what needs the language server's documents is
// in service.cc. What cannot be answered is a Refusal.

#include <span>
#include <string_view>

#include "runtime/service/answer.h"
#include "runtime/service/request.h"

namespace plsc::service {

/// check.cc
Answer Check(const Request& request);
Answer FormatText(const Request& request);
/// develop.cc
Answer DevelopAll(const Request& request);
/// show.cc
Answer Explain(const Request& request);
Answer Draw(const Request& request);
/// live.cc
Answer LiveAll(const Request& request);
/// compare.cc
Answer Compare(const Request& request);
/// parameters.cc
Answer Parameters(const Request& request);
/// scenario.cc
Answer ShowScenario(const Request& request);

struct Ask {
  std::string_view name;
  std::span<const std::string_view> keys;  ///< beside id and ask
  Answer (*answer)(const Request& request);
};
/// In the order of docs/service.md.
std::span<const Ask> Asks();

}  // namespace plsc::service
