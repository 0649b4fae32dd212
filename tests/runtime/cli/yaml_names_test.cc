// Names that YAML's readers take for something else stay names, whoever reads
// what we print: our own reader, and PyYAML, which has YAML 1.1's words.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "runtime/study/study.h"
#include "runtime/text/yaml_reader.h"
#include "runtime/text/yaml_text.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/shell.h"

namespace plsc {
namespace {

const std::vector<std::string> kNames = {
    "no",       "yes",   "on",    "off",     "y",          "N",    "null",
    "Null",     "NULL",  "true",  "False",   "1e3",        "0x10", "0o17",
    "017",      "1_000", "12",    "1.5",     "2026-01-01", "nan",  "inf",
    "infinity", "_",     "_1",    "e3",      "-1",         "-",    "none",
    "plastic",  "1.",    "0b101", "190_20.5"};

// Texts of any characters.
std::vector<std::string> HostileTexts() {
  std::vector<std::string> texts = kNames;
  for (const char* text : {"~",
                           "",
                           " ",
                           ".inf",
                           ".nan",
                           "12:30:45",
                           "2001-12-14t21:59:43.10-05:00",
                           "<<",
                           "=",
                           "*a",
                           "&a",
                           "!x",
                           "%x",
                           "@x",
                           "`x",
                           "a: b",
                           "a #b",
                           "'",
                           "\"",
                           "- a",
                           "? a",
                           "[a",
                           "{a",
                           "a\nb",
                           "\t",
                           "\x01",
                           "\x7F",
                           "\u0085",
                           "\u00A0",
                           "\u2028",
                           "\uFEFF",
                           "\U0001F916",
                           "trailing ",
                           "\\",
                           "|",
                           ">"})
    texts.emplace_back(text);
  std::mt19937 random(7);  // NOLINT(bugprone-random-generator-seed)
  const std::string letters = "yYnNoOeE01x._-~:#,'\"[]{}&*!|>% \n";
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (auto size = random() % 6; size > 0; --size)
      text += letters[random() % letters.size()];
    texts.push_back(text);
  }
  return texts;
}

// What PyYAML reads, or null where there is none.
nlohmann::json ReadByPython(const std::string& yaml) {
  if (test::RunShell("python3 -c 'import yaml'").status != 0) {
    WARN("python3 has no yaml: not compared with PyYAML");
    return nullptr;
  }
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("a.yaml", yaml);
  const auto ran = test::RunShell(
      "python3 -c 'import json, sys, yaml; "
      "print(json.dumps(yaml.safe_load(open(sys.argv[1], \"rb\"))))' '" +
      file + "'");
  INFO(ran.out);
  REQUIRE(ran.status == 0);
  return nlohmann::json::parse(ran.out);
}

TEST_CASE("Printed texts are texts for every reader", "[yaml]") {
  const std::vector<std::string> texts = HostileTexts();
  std::string yaml = "texts:\n";
  for (const std::string& text : texts)
    yaml += fmt::format("  - {}\n", PrintYamlText(text));
  const Source source("test.yaml", yaml);
  const YamlFile file(source);
  auto root = file.Root("a test");
  REQUIRE(root);
  const auto items = root->Find("texts")->List("texts");
  REQUIRE(items->size() == texts.size());
  const nlohmann::json python = ReadByPython(yaml);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    CAPTURE(texts[i]);
    CHECK((*items)[i].text() == texts[i]);
    if (!python.is_null())
      CHECK(python["texts"][i] == nlohmann::json(texts[i]));
  }
}

// Every name of a study is one of those.
Study StudyOfNames() {
  Study study;
  study.name = "no";
  for (const std::string& name : kNames) {
    StudyExperiment one;
    one.name = name;
    Experiment& experiment = one.experiment;
    experiment.robots = "yes";
    experiment.scenario.name = name;
    Season& season = experiment.scenario.seasons[0];
    season.name = name;
    State state;
    state.name = "on";
    state.type = StateType::kEnum;
    state.values = {"off", "null"};
    experiment.genotype.states = {state};
    for (Season& each : experiment.scenario.seasons)
      each.senses = {{"on", "off"}, {"hot", "True"}};
    study.experiments.push_back(one);
  }
  return study;
}

TEST_CASE("The names of a study are names for every reader", "[study][yaml]") {
  const Study study = StudyOfNames();
  const std::string yaml = PrintStudy(study);
  const auto back = ParseStudy(Source("study.yaml", yaml));
  INFO((back ? "" : back.diagnostics()[0].message));
  REQUIRE(back);
  CHECK(*back == study);
  const nlohmann::json python = ReadByPython(yaml);
  if (python.is_null()) return;
  CHECK(python["name"] == "no");
  for (const std::string& name : kNames) {
    CAPTURE(name);
    REQUIRE(python["experiments"].contains(name));
    const nlohmann::json& one = python["experiments"][name];
    CHECK(one["robots"] == "yes");
    CHECK(one["scenario"]["name"] == name);
    const nlohmann::json& season = one["scenario"]["seasons"][0];
    CHECK(season["name"] == name);
    CHECK(season["senses"] == nlohmann::json{{"on", "off"}, {"hot", true}});
    CHECK(one["states"] ==
          nlohmann::json::parse(R"([{"on": ["off", "null"]}])"));
  }
}

}  // namespace
}  // namespace plsc
