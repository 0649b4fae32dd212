#include "runtime/text/diagnostic_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/text/json_dump.h"

namespace plsc {

namespace {

using OrderedJson = nlohmann::ordered_json;

void AddPlace(OrderedJson& json, Span span, const Source& source) {
  const Position position = source.PositionOf(span.begin);
  json["line"] = position.line;
  json["column"] = position.column;
  json["byte_begin"] = span.begin;
  json["byte_end"] = span.end;
}

}  // namespace

std::string DiagnosticJson(const Diagnostic& diagnostic, const Source& source) {
  OrderedJson json;
  json["severity"] =
      diagnostic.severity == Severity::kError ? "error" : "warning";
  json["code"] = NumberOf(diagnostic.code);
  json["message"] = diagnostic.message;
  json["label"] = diagnostic.label;
  json["file"] = source.name();
  AddPlace(json, diagnostic.span, source);
  json["others"] = OrderedJson::array();
  for (const Label& label : diagnostic.others) {
    OrderedJson other;
    other["text"] = label.text;
    AddPlace(other, label.span, source);
    json["others"].push_back(std::move(other));
  }
  json["notes"] = diagnostic.notes;
  json["help"] = diagnostic.help;
  json["fixes"] = OrderedJson::array();
  for (const Fix& fix : diagnostic.fixes) {
    OrderedJson change;
    AddPlace(change, fix.span, source);
    change["replacement"] = fix.replacement;
    json["fixes"].push_back(std::move(change));
  }
  // Text of the user's may be any bytes; JSON must stay UTF-8.
  return DumpJson(json);
}

std::string DiagnosticsJson(const std::vector<Diagnostic>& diagnostics,
                            const Source& source) {
  std::string all;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!all.empty()) all += ',';
    all += DiagnosticJson(diagnostic, source);
  }
  return all;
}

std::string HeadlineOf(const Diagnostic& diagnostic) {
  return fmt::format("{}: {}", NumberOf(diagnostic.code), diagnostic.message);
}

}  // namespace plsc
