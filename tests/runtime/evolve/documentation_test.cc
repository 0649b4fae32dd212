// docs/experiments.md says what experiment and scenario files can hold.

#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/formula/functions.h"
#include "runtime/formula/quantities.h"
#include "runtime/scenario/scenario_fitness.h"

namespace plsc {

namespace {

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string Documentation() {
  std::ifstream file(PLSC_SOURCE_DIR "/docs/experiments.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Texts between ```yaml and ```.
std::vector<std::string> Examples() {
  std::vector<std::string> examples;
  bool is_inside = false;
  for (const std::string& line : Lines(Documentation())) {
    if (line == "```yaml") {
      examples.emplace_back();
      is_inside = true;
    } else if (line == "```") {
      is_inside = false;
    } else if (is_inside) {
      examples.back() += line + "\n";
    }
  }
  return examples;
}

/// "  step: 5 ms" and "  - name: flat" are the keys step and name.
std::set<std::string> KeysOf(const std::string& yaml) {
  std::set<std::string> keys;
  for (const std::string& line : Lines(yaml)) {
    const std::size_t begin = line.find_first_not_of(" -");
    const std::size_t end = line.find(':');
    if (begin != std::string::npos && end != std::string::npos)
      keys.insert(line.substr(begin, end - begin));
  }
  return keys;
}

}  // namespace

TEST_CASE("The examples of the documentation are experiments",
          "[documentation]") {
  const std::vector<std::string> examples = Examples();
  REQUIRE(examples.size() == 3);
  for (const std::string& example : examples) {
    const Source source("docs/experiments.md", example);
    const auto experiment = ParseExperiment(source);
    INFO(Render(experiment.diagnostics(), source));
    REQUIRE(experiment);
  }
  Experiment paper;
  paper.name = "paper";
  CHECK(*ParseExperiment(Source("docs", examples[0])) == paper);
  const auto thrift = ParseExperiment(Source("docs", examples[2]));
  CHECK(HasOwnFitness(thrift->scenario));
  const auto deserts = ParseExperiment(Source("docs", examples[1]));
  CHECK(deserts->scenario.seasons.size() == 3);
  CHECK(deserts->genotype.states.size() == 3);
}

TEST_CASE("Formulas' quantities and functions are documented",
          "[documentation]") {
  const std::string documentation = Documentation();
  for (const QuantityInfo& one : Quantities()) {
    const std::string other =
        one.column.empty() ? "" : " or `" + std::string(one.column) + "`";
    const std::string row = "\n| `" + std::string(one.name) + "`" + other +
                            " | " + std::string(one.unit) + " | " +
                            std::string(one.meaning) + " |\n";
    CAPTURE(row);
    CHECK(documentation.find(row) != std::string::npos);
  }
  for (const FormulaFunction& one : FormulaFunctions()) {
    const std::string row = "\n| `" + std::string(one.name) + "(" +
                            std::string(one.arguments) + ")` | " +
                            std::string(one.meaning) + " |\n";
    CAPTURE(row);
    CHECK(documentation.find(row) != std::string::npos);
  }
  CHECK(documentation.find("\n    " + std::string(kDefaultFitness) + "\n") !=
        std::string::npos);
}

TEST_CASE("Every key is in the example of all keys and in the tables",
          "[documentation]") {
  const std::string documentation = Documentation();
  std::set<std::string> keys = KeysOf(PrintExperiment(Experiment{}));
  CHECK(keys.size() > 40);
  keys.insert("plsc_scenario");
  keys.insert("targets");
  keys.insert("name");
  for (const std::string& key : keys) {
    CAPTURE(key);
    CHECK(documentation.find("\n| `" + key + "` |") != std::string::npos);
  }
  keys.erase("plsc_scenario");
  keys.erase("targets");
  CHECK(KeysOf(Examples().at(0)) == keys);
}

TEST_CASE("The example experiments of the repository are right",
          "[documentation]") {
  std::ifstream file(PLSC_SOURCE_DIR "/examples/small.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  const Source source("examples/small.yaml", text.str());
  const auto experiment = ParseExperiment(source);
  INFO(Render(experiment.diagnostics(), source));
  REQUIRE(experiment);
  CHECK(experiment->population == 20);
}

}  // namespace plsc
