#include "tests/runtime/develop/reference_cases.h"

#include <fstream>
#include <stdexcept>

namespace plsc::test {

namespace {

const char* Truth(const Json& value) {
  return value.get<bool>() ? "True" : "False";
}

std::string ClauseText(const Json& clause) {
  std::string text = "if";
  for (const Json& part : clause) {
    text += ' ';
    if (part.is_array())
      text += part[0].get<std::string>() + " = " + Truth(part[1]);
    else
      text += part.get<std::string>();
  }
  return text + " then ";
}

std::string SymbolText(const Json& symbol) {
  std::string text = symbol[0].get<std::string>();
  const Json& parameters = symbol[1];
  for (std::size_t i = 0; i < parameters.size(); ++i)
    text += (i == 0 ? "(" : ", ") + parameters[i].dump();
  return parameters.empty() ? text : text + ")";
}

}  // namespace

const std::vector<std::string>& ReferenceSets() {
  static const std::vector<std::string> kSets{
      "sample_plastic", "sample_baseline", "sample_two_states", "sample_rare"};
  return kSets;
}

std::vector<Json> ReadReferenceCases(const std::string& set) {
  const std::string path =
      std::string(PLSC_TEST_DATA_DIR) + "/" + set + ".jsonl";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<Json> cases;
  for (std::string line; std::getline(file, line);)
    cases.push_back(Json::parse(line));
  return cases;
}

std::string GenotypeText(const Json& reference_case) {
  const Json& settings = reference_case["settings"];
  std::string text = "plsc 1\ngenotype reference\nalphabet plasticoding 1\n";
  for (const Json& state : settings["states"])
    text += "sense " + state.get<std::string>() + ": bool\n";
  text += "iterations " + settings["k"].dump() + "\n";
  text += "max_modules " + settings["max_modules"].dump() + "\n";
  text += std::string("move_to_new ") + Truth(settings["move_to_new"]) + "\n";
  for (const char* head : {"C", "B", "A1", "A2", "T"})
    for (const Json& rule : reference_case["genotype"][head]) {
      text += std::string("rule ") + head + " -> ";
      if (!rule["clause"].is_null()) text += ClauseText(rule["clause"]);
      text += "{";
      for (const Json& symbol : rule["rule"]) text += " " + SymbolText(symbol);
      text += " }\n";
    }
  return text;
}

std::string EnvironmentText(const Json& reference_case) {
  const Json& environment = reference_case["environment"];
  return std::string("inclined=") + Truth(environment["inclined"]) +
         ",hot=" + Truth(environment["hot"]);
}

}  // namespace plsc::test
