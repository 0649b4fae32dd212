// The service answers any bytes, in words or as it was asked, and equal
// requests with equal bytes. An input that begins with '{' is a list of
// requests, one a line; any other is a genotype that everything is asked about.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fuzz/require.h"
#include "runtime/service/service.h"

namespace {

using Json = nlohmann::json;
using plsc::fuzz::Require;

// A life of some steps; what an input makes up could be of a million.
constexpr const char* kScenario =
    "plsc_scenario: 1\nseasons:\n"
    "  - {name: a, terrain: flat, duration: 0.2 s, senses: {hot: False}}\n"
    "  - {name: b, terrain: {tilted: 5 deg}, duration: 0.2 s, "
    "senses: {hot: True}}\n";

Json AnswerTo(plsc::Service& service, std::string_view request) {
  const std::string answer = service.Answer(request);
  Require(answer.find('\n') == std::string::npos, "an answer is one line");
  Json json = Json::parse(answer, nullptr, false);
  Require(json.is_object(), "an answer is a JSON object");
  Require(json.contains("id") && json.contains("ask"),
          "an answer says what it is an answer to");
  Require(json["ok"].is_boolean(), "an answer says whether it is one");
  Require(json["ok"] == true || json["error"].is_string(),
          "what is not answered is answered with words");
  return json;
}

/// The same of two services, which know nothing but the request.
Json Ask(Json request) {
  if (request.value("ask", Json()) == "live") request["scenario"] = kScenario;
  const std::string text =
      request.dump(-1, ' ', false, Json::error_handler_t::replace);
  plsc::Service one("fuzz");
  plsc::Service other("fuzz");
  Require(one.Answer(text) == other.Answer(text),
          "equal requests have equal answers");
  return AnswerTo(one, text);
}

void AnswerLines(std::string_view text) {
  plsc::Service service("fuzz");
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const Json request = Json::parse(line, nullptr, false);
    // Only lives take long.
    if (request.is_object() && request.value("ask", Json()) == "live")
      Ask(request);
    else
      AnswerTo(service, line);
  }
}

void AskEverything(const std::string& text) {
  const Json checked = Ask({{"ask", "check"}, {"text", text}, {"lint", true}});
  const Json formatted = Ask({{"ask", "format"}, {"text", text}});
  Require(checked["ok"] == false || checked["fine"] == formatted["ok"],
          "what compiles is formatted");
  if (formatted["ok"] == true) {
    const Json again = Ask({{"ask", "format"}, {"text", formatted["text"]}});
    Require(again["changed"] == false, "what was formatted is");
  }
  Ask({{"ask", "parameters"}, {"text", text}});
  const auto lines = std::count(text.begin(), text.end(), '\n');
  Ask({{"ask", "parameters"},
       {"text", text},
       {"at", {{"line", lines / 2 + 1}, {"column", 1}}}});
  for (const char* ask : {"develop", "explain", "picture"})
    Ask({{"ask", ask}, {"text", text}, {"scenario", kScenario}});
  for (const char* engine : {"ode", "articulated"})
    Ask({{"ask", "live"}, {"text", text}, {"engine", engine}});
  const Json same = Ask({{"ask", "compare"}, {"before", text}, {"text", text}});
  if (same["ok"] == true)
    Require(same["difference"]["differs"] == false, "a text is itself");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const std::string text(source.text());
  if (text.starts_with('{'))
    AnswerLines(text);
  else
    AskEverything(text);
  return 0;
}
