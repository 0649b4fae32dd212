#include "runtime/cli/commands/ask_tell.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "runtime/life/season_json.h"
#include "runtime/text/diagnostic_json.h"
#include "runtime/text/json_place.h"
#include "runtime/text/json_reader.h"
#include "runtime/text/json_text.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

// Longer ones would come back with every answer.
constexpr std::size_t kLongestId = 256;

template <typename AnyJson>
bool IsId(const AnyJson& json) {
  if (json.is_number_integer() || json.is_null()) return true;
  return json.is_string() &&
         json.template get_ref<const std::string&>().size() <= kLongestId;
}

std::string JsonString(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string FailedAnswer(const std::string& id, std::size_t line,
                         const std::string& message,
                         const std::string& diagnostics) {
  return fmt::format(R"({{"id":{},"line":{},"error":{},"diagnostics":[{}]}})",
                     id, line, JsonString(message), diagnostics);
}

}  // namespace

Result<EvaluationRequest> ParseEvaluationRequest(const Source& line) {
  static constexpr std::array<std::string_view, 2> kKnown{"id", "genotype"};
  const Result<nlohmann::json> json = ReadJson(line);
  if (!json) return json.diagnostics();
  JsonReader reader(line);
  const JsonValue whole{*json, nullptr, ""};
  EvaluationRequest request;
  if (reader.IsObject(whole, kKnown)) {
    request.genotype = reader.Text(whole, "genotype");
    if (reader.Has(whole, "id")) {
      const nlohmann::json& id = (*json)["id"];
      if (!IsId(id))
        reader.Wrong({id, &whole, "id"},
                     fmt::format("a whole number, or a text of at most {} "
                                 "bytes",
                                 kLongestId));
      request.id = id.dump();
    }
  }
  if (!reader.errors().empty()) return reader.errors();
  return request;
}

std::string IdOfRequest(const std::string& line) {
  if (TooDeepInJson(line)) return "null";
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("id") || !IsId(json["id"]))
    return "null";
  return json["id"].dump();
}

std::string EvaluationAnswer(const std::string& id, const Genotype& genotype,
                             const Evaluation& evaluation) {
  return fmt::format(R"({{"id":{},{}}})", id,
                     EvaluationJson(genotype, evaluation));
}

std::string FailureAnswer(const std::string& id, std::size_t line,
                          const std::vector<Diagnostic>& diagnostics,
                          const Source& source) {
  return FailedAnswer(id, line, HeadlineOf(diagnostics.front()),
                      DiagnosticsJson(diagnostics, source));
}

std::string FailureAnswer(const std::string& id, std::size_t line,
                          const std::string& failure) {
  return FailedAnswer(id, line, failure, "");
}

}  // namespace plsc::cli
