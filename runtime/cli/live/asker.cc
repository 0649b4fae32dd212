#include "runtime/cli/live/asker.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

/// A process that is forked later than the page's first question begins anew,
/// as make_work is called in it and not here.
Work Later(const std::function<Work()>& make_work) {
  return [make_work, work = Work()](const std::string& request) mutable {
    if (!work) work = make_work();
    return work(request);
  };
}

/// Whether it may take long, which editing must not wait for.
bool IsLong(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("ask") || !json["ask"].is_string())
    return false;
  const auto& ask = json["ask"].get_ref<const std::string&>();
  return ask == "live" || ask == "explain" || ask == "picture";
}

}  // namespace

Asker::Asker(const AskerOptions& options,
             const std::function<Work()>& make_work)
    : editing_{WorkerPool({1, options.patience}, Later(make_work)), {}, {}},
      lives_{WorkerPool({options.lives, options.patience}, Later(make_work)),
             {},
             {}} {}

void Asker::Ask(std::string question, server::HttpServer::Respond respond,
                std::function<bool()> is_wanted) {
  Desk& desk = IsLong(question) ? lives_ : editing_;
  desk.waiting.push_back(
      {std::move(question), std::move(respond), std::move(is_wanted)});
}

bool Asker::Step() {
  const bool is_editing = editing_.Step(tickets_);
  return lives_.Step(tickets_) || is_editing;
}

bool Asker::Desk::Step(int& tickets) {
  while (!waiting.empty() && pool.busy() < pool.workers()) {
    Question next = std::move(waiting.front());
    waiting.pop_front();
    if (!next.is_wanted()) continue;
    const int ticket = ++tickets;
    pool.Submit(ticket, std::move(next.text));
    begun.emplace(ticket, std::move(next));
  }
  for (Reply& reply : pool.Wait(0)) {
    const auto found = begun.find(reply.ticket);
    server::Response response;
    if (reply.answer) {
      response.body = std::move(*reply.answer);
    } else {
      response.body = DumpJson(Json{
          {"ok", false},
          {"error", fmt::format("it could not be computed: {}", reply.death)}});
    }
    found->second.respond(std::move(response));
    begun.erase(found);
  }
  if (const auto& failure = pool.failure()) {
    for (auto& [ticket, one] : begun)
      one.respond(server::Refusal(503, *failure));
    for (Question& one : waiting) one.respond(server::Refusal(503, *failure));
    begun.clear();
    waiting.clear();
  }
  return !waiting.empty() || !begun.empty();
}

}  // namespace plsc::cli
