#include "runtime/cli/diagnostics/sarif.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "grammar/codes.h"
#include "runtime/cli/explanations/explanations.h"
#include "runtime/text/json_dump.h"
#include "runtime/text/version.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/"
    "sarif-schema-2.1.0.json";

// Codes and where each stands in the list of rules.
using RuleIndex = std::map<Code, std::size_t>;

const char* LevelOf(Severity severity) {
  return severity == Severity::kError ? "error" : "warning";
}

// A path as the reference part of a URI (RFC 3986, section 2.3 and 3.3).
std::string UriOf(const std::string& path) {
  static constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    if (kPlain.find(c) != std::string_view::npos)
      uri += c;
    else
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json RegionOf(Span span, const Source& source) {
  const Position begin = source.PositionOf(span.begin);
  const Position end = source.PositionOf(std::max(span.begin, span.end));
  Json region;
  region["startLine"] = begin.line;
  region["startColumn"] = begin.column;
  region["endLine"] = end.line;
  region["endColumn"] = end.column;
  region["byteOffset"] = span.begin;
  region["byteLength"] = std::max(span.begin, span.end) - span.begin;
  return region;
}

Json LocationOf(Span span, const Source& source) {
  Json location;
  location["physicalLocation"]["artifactLocation"]["uri"] =
      UriOf(source.name());
  location["physicalLocation"]["region"] = RegionOf(span, source);
  return location;
}

std::string WholeMessage(const Diagnostic& diagnostic) {
  std::string text = diagnostic.message;
  if (!diagnostic.label.empty()) text += ": " + diagnostic.label;
  for (const std::string& note : diagnostic.notes) text += "\nnote: " + note;
  if (!diagnostic.help.empty()) text += "\nhelp: " + diagnostic.help;
  return text;
}

Json FixOf(const Diagnostic& diagnostic, const Source& source) {
  Json change;
  change["artifactLocation"]["uri"] = UriOf(source.name());
  change["replacements"] = Json::array();
  for (const Fix& fix : diagnostic.fixes) {
    Json replacement;
    replacement["deletedRegion"] = RegionOf(fix.span, source);
    replacement["insertedContent"]["text"] = fix.replacement;
    change["replacements"].push_back(std::move(replacement));
  }
  Json json;
  json["description"]["text"] = "as 'plsc fix' makes it";
  json["artifactChanges"] = Json::array({std::move(change)});
  return json;
}

Json ResultOf(const Diagnostic& diagnostic, const Source& source,
              const RuleIndex& rules) {
  Json result;
  const auto rule = rules.find(diagnostic.code);
  if (rule != rules.end()) {
    result["ruleId"] = NumberOf(rule->first);
    result["ruleIndex"] = rule->second;
  }
  result["level"] = LevelOf(diagnostic.severity);
  result["message"]["text"] = WholeMessage(diagnostic);
  result["locations"] = Json::array({LocationOf(diagnostic.span, source)});
  if (!diagnostic.others.empty()) {
    result["relatedLocations"] = Json::array();
    for (const Label& label : diagnostic.others) {
      Json related = LocationOf(label.span, source);
      related["message"]["text"] = label.text;
      result["relatedLocations"].push_back(std::move(related));
    }
  }
  if (!diagnostic.fixes.empty())
    result["fixes"] = Json::array({FixOf(diagnostic, source)});
  return result;
}

Json RuleOf(Code code) {
  Json rule;
  rule["id"] = NumberOf(code);
  rule["shortDescription"]["text"] = MeaningOf(code);
  if (const Explanation* explanation = FindExplanation(code)) {
    rule["fullDescription"]["text"] = explanation->text;
    rule["help"]["text"] =
        fmt::format("{}\nWrong:\n\n{}\nRight:\n\n{}", explanation->text,
                    explanation->wrong, explanation->mended);
  }
  rule["defaultConfiguration"]["level"] =
      NumberOf(code).starts_with('W') ? "warning" : "error";
  return rule;
}

}  // namespace

std::string Sarif(const std::vector<CheckedFile>& files) {
  RuleIndex rules;
  for (const CheckedFile& file : files)
    for (const Diagnostic& diagnostic : file.diagnostics)
      rules[diagnostic.code] = 0;
  Json driver;
  driver["name"] = "plsc";
  driver["version"] = kVersion;
  driver["rules"] = Json::array();
  for (auto& [code, index] : rules) {
    index = driver["rules"].size();
    driver["rules"].push_back(RuleOf(code));
  }
  Json run;
  run["tool"]["driver"] = std::move(driver);
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = Json::array();
  for (const CheckedFile& file : files)
    for (const Diagnostic& diagnostic : file.diagnostics)
      run["results"].push_back(ResultOf(diagnostic, file.source, rules));
  Json document;
  document["$schema"] = kSchema;
  document["version"] = "2.1.0";
  document["runs"] = Json::array({std::move(run)});
  // Text of the user's may be any bytes; JSON must stay UTF-8.
  return DumpJson(document, 2) + "\n";
}

}  // namespace plsc::cli
