#include "runtime/cli/diagnostics/diagnostic_json.h"

#include <nlohmann/json.hpp>

#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

void AddPlace(Json& json, Span span, const Source& source) {
  const Position position = source.PositionOf(span.begin);
  json["line"] = position.line;
  json["column"] = position.column;
  json["byte_begin"] = span.begin;
  json["byte_end"] = span.end;
}

}  // namespace

std::string DiagnosticJson(const Diagnostic& diagnostic, const Source& source) {
  Json json;
  json["severity"] =
      diagnostic.severity == Severity::kError ? "error" : "warning";
  json["code"] = NumberOf(diagnostic.code);
  json["message"] = diagnostic.message;
  json["label"] = diagnostic.label;
  json["file"] = source.name();
  AddPlace(json, diagnostic.span, source);
  json["others"] = Json::array();
  for (const Label& label : diagnostic.others) {
    Json other;
    other["text"] = label.text;
    AddPlace(other, label.span, source);
    json["others"].push_back(std::move(other));
  }
  json["notes"] = diagnostic.notes;
  json["help"] = diagnostic.help;
  json["fixes"] = Json::array();
  for (const Fix& fix : diagnostic.fixes) {
    Json change;
    AddPlace(change, fix.span, source);
    change["replacement"] = fix.replacement;
    json["fixes"].push_back(std::move(change));
  }
  // Text of the user's may be any bytes; JSON must stay UTF-8.
  return DumpJson(json);
}

}  // namespace plsc::cli
