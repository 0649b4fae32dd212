#include "runtime/service/service.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "grammar/suggest.h"
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

service::Answer About(const std::string& version) {
  service::Answer answer;
  answer.Add("version", version);
  answer.Add("engines", AllNames(kEngineNames));
  Json asks = Json::array();
  for (const service::Ask& ask : service::Asks()) asks.push_back(ask.name);
  asks.push_back("about");
  answer.Add("asks", asks);
  answer.Add("limits", {{"request_bytes", service::kMostRequestBytes},
                        {"text_bytes", service::kMostTextBytes},
                        {"name_bytes", service::kMostNameBytes},
                        {"environments", service::kMostEnvironments},
                        {"symbols", service::kMostSymbols},
                        {"link_steps", service::kMostLinkSteps}});
  return answer;
}

}  // namespace

class Service::State {
 public:
  explicit State(std::string version) : version_(std::move(version)) {}

  service::Answer AnswerTo(const Request& request) {
    const std::string name = request.Ask();
    if (name == "about") {
      request.RefuseUnknown({});
      return About(version_);
    }
    std::vector<std::string_view> names{"about"};
    for (const service::Ask& ask : service::Asks()) {
      names.push_back(ask.name);
      if (ask.name != name) continue;
      request.RefuseUnknown(ask.keys);
      return ask.answer(request);
    }
    const auto near = Suggest(name, names);
    throw Refusal(fmt::format("expected 'ask' to be one of {}{}",
                              fmt::join(names, ", "),
                              near ? "; did you mean '" + *near + "'?" : ""));
  }

 private:
  std::string version_;
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
