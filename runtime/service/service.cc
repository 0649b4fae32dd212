#include "runtime/service/service.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "grammar/suggest.h"
#include "runtime/history/explained_robot.h"
#include "runtime/lsp/server.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/service/asks.h"
#include "runtime/service/limits.h"
#include "runtime/service/refusal.h"
#include "runtime/text/json_text.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;
using service::Refusal;
using service::Request;

/// What comes before the members of an answer, all of it written.
std::string Head(const std::string& id, const std::string& ask, bool is_ok) {
  return fmt::format(R"({{"id":{},"ask":{},"ok":{})", id, ask, is_ok);
}

std::string Refused(const std::string& id, const std::string& ask,
                    const Refusal& refusal) {
  std::string text =
      Head(id, ask, false) + ",\"error\":" + service::Quoted(refusal.what());
  if (!refusal.diagnostics().empty())
    text += ",\"diagnostics\":[" + refusal.diagnostics() + "]";
  return text + "}";
}

Request Read(std::string_view text) {
  if (text.size() > service::kMostRequestBytes)
    throw Refusal(fmt::format("the request has {} bytes, more than {}",
                              text.size(), service::kMostRequestBytes));
  const Source source("request", std::string(text));
  Result<nlohmann::json> json = ReadJson(source);
  if (!json) throw Refusal(json.diagnostics(), source);
  if (!json->is_object()) throw Refusal("expected one JSON object a request");
  return Request(std::move(*json));
}

service::Answer About(const std::string& version,
                      const std::vector<std::string_view>& asks) {
  service::Answer answer;
  answer.Add("version", version);
  Json engines = Json::array();
  for (const auto& [engine, name] : kEngineNames)
    if (engine != EngineKind::kOde || HasOde()) engines.push_back(name);
  answer.Add("engines", engines);
  answer.Add("asks", asks);
  answer.Add("limits", {{"request_bytes", service::kMostRequestBytes},
                        {"text_bytes", service::kMostTextBytes},
                        {"scenario_bytes", service::kMostScenarioBytes},
                        {"name_bytes", service::kMostNameBytes},
                        {"environments", service::kMostEnvironments},
                        {"symbols", service::kMostSymbols},
                        {"link_steps", service::kMostLinkSteps},
                        {"explained_symbols", kMostExplainedSymbols},
                        {"parameters", service::kMostNumbers}});
  return answer;
}

}  // namespace

class Service::State {
 public:
  explicit State(std::string version)
      : version_(std::move(version)), editor_(NewEditor()) {}

  service::Answer AnswerTo(const Request& request) {
    const std::string name = request.Ask();
    if (name == "lsp") return HandleMessage(request);
    if (name == "idle") return WorkOn(request);
    if (name == "about") {
      request.RefuseUnknown({});
      return About(version_, Names());
    }
    for (const service::Ask& ask : service::Asks()) {
      if (ask.name != name) continue;
      request.RefuseUnknown(ask.keys);
      return ask.answer(request);
    }
    const auto near = Suggest(name, Names());
    throw Refusal(fmt::format("expected 'ask' to be one of {}{}",
                              fmt::join(Names(), ", "),
                              near ? "; did you mean '" + *near + "'?" : ""));
  }

 private:
  static std::vector<std::string_view> Names() {
    std::vector<std::string_view> names{"about"};
    for (const service::Ask& ask : service::Asks()) names.push_back(ask.name);
    names.insert(names.end(), {"lsp", "idle"});
    return names;
  }

  std::unique_ptr<lsp::Server> NewEditor() const {
    return std::make_unique<lsp::Server>(version_);
  }

  service::Answer HandleMessage(const Request& request) {
    request.RefuseUnknown(std::array<std::string_view, 1>{"message"});
    return Sent(editor_->Handle(request.Object("message").dump()));
  }

  service::Answer WorkOn(const Request& request) {
    request.RefuseUnknown({});
    return Sent(editor_->has_work() ? editor_->Idle()
                                    : std::vector<std::string>());
  }

  service::Answer Sent(const std::vector<std::string>& messages) {
    // Whoever says goodbye may come again.
    if (editor_->exit_status()) editor_ = NewEditor();
    service::Answer answer;
    answer.AddWritten("messages",
                      fmt::format("[{}]", fmt::join(messages, ",")));
    answer.Add("has_work", editor_->has_work());
    return answer;
  }

  std::string version_;
  std::unique_ptr<lsp::Server> editor_;
};

Service::Service(std::string version)
    : state_(std::make_unique<State>(std::move(version))) {}

Service::~Service() = default;

std::string Service::Answer(std::string_view text) {
  std::string id = "null";
  std::string ask = "null";
  try {
    const Request request = Read(text);
    id = request.Id();
    ask = service::Quoted(request.Ask());
    const service::Answer answer = state_->AnswerTo(request);
    std::string whole = Head(id, ask, true);
    if (!answer.members().empty()) whole += "," + answer.members();
    // Files end in a newline; between the parts of JSON it means nothing.
    std::erase(whole, '\n');
    return whole + "}";
  } catch (const Refusal& refusal) {
    return Refused(id, ask, refusal);
  }
}

}  // namespace plsc
