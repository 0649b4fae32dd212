// What a file of ours is told when it is wrong: one error for one mistake, and
// whatever it is told to write is accepted. Every key of a printed experiment
// is tried, so that a new key is tried, too.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <regex>
#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/scenario/scenario.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/study/study.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

// Every key there is.
std::string WholeExperiment() {
  std::string text = PrintExperiment(Experiment{});
  const std::string seasons = "  seasons:\n";
  const std::string blanks = "    ";
  std::string more = seasons;
  const char* grounds[] = {
      "{rough: {seed: 3, amplitude: 0.02 m, wavelength: 0.3 m}}",
      "{steps: {height: 0.01 m, depth: 0.4 m, count: 5}}",
      "{obstacles: {seed: 3, spacing: 0.5 m, size: 0.1 m, height: 0.02 m}}"};
  for (int i = 0; i < 3; ++i)
    more += fmt::format(
        "{}- name: other{}\n{}  terrain: {}\n{}  duration: 20 s\n"
        "{}  physics: {{gravity: 1.62 m/s2}}\n",
        blanks, i, blanks, grounds[i], blanks, blanks);
  text.replace(text.find(seasons), seasons.size(), more);
  return text;
}

std::vector<Diagnostic> HelpErrors(const std::string& text) {
  const Source source("experiment.yaml", text);
  return ParseExperiment(source).diagnostics();
}

// A key and its value, if that is a scalar.
struct Pair {
  std::size_t key_at = 0;
  std::string key;
  std::size_t value_at = 0;
  std::string value;
};

std::vector<Pair> PairsOf(const std::string& text) {
  static const std::regex pattern("([a-z_]+):(?: ([^,{}\\[\\]\\n]+))?");
  std::vector<Pair> pairs;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end;
       at != end; ++at)
    pairs.push_back({static_cast<std::size_t>(at->position(1)), (*at)[1],
                     static_cast<std::size_t>(at->position(2)), (*at)[2]});
  return pairs;
}

std::string Replaced(std::string text, std::size_t at, std::size_t size,
                     const std::string& by) {
  return text.replace(at, size, by);
}

// What the help says: the first 'text' in quotes. Empty: none.
std::string Advised(const Diagnostic& diagnostic) {
  const std::string& help = diagnostic.help;
  const bool is_advice =
      help.starts_with("write") || help.starts_with("did you mean");
  const std::size_t begin = help.find('\'');
  if (!is_advice || begin == std::string::npos) return "";
  return help.substr(begin + 1, help.find('\'', begin + 1) - begin - 1);
}

// One edit: the first letter gone, one doubled, the last two swapped.
std::vector<std::string> TyposOf(const std::string& word) {
  if (word.size() < 2) return {};
  std::vector<std::string> typos = {word.substr(1), word, word};
  typos[1].insert(word.size() / 2, 1, word[word.size() / 2]);
  std::swap(typos[2][word.size() - 2], typos[2][word.size() - 1]);
  std::erase(typos, word);
  return typos;
}

TEST_CASE("The experiment that is tried is right", "[yaml][help]") {
  const std::vector<Diagnostic> errors = HelpErrors(WholeExperiment());
  INFO((errors.empty() ? "" : errors[0].message + errors[0].help));
  CHECK(errors.empty());
  CHECK(PairsOf(WholeExperiment()).size() > 90);
}

TEST_CASE("A misspelt key is one error, and its advice mends it",
          "[yaml][help]") {
  const std::string text = WholeExperiment();
  for (const Pair& pair : PairsOf(text)) {
    // Names of states are the user's.
    if (pair.key == "inclined" || pair.key == "hot") continue;
    for (const std::string& typo : TyposOf(pair.key)) {
      const std::string wrong =
          Replaced(text, pair.key_at, pair.key.size(), typo);
      const auto errors = HelpErrors(wrong);
      INFO(pair.key << " as " << typo);
      REQUIRE(errors.size() == 1);
      const std::string advised = Advised(errors[0]);
      INFO(errors[0].message << " / " << errors[0].help);
      if (pair.key.size() > 3) REQUIRE(!advised.empty());
      if (advised.empty()) continue;
      CHECK(errors[0].span.begin == pair.key_at);
      REQUIRE(errors[0].fixes.size() == 1);
      CHECK(errors[0].fixes[0].replacement == advised);
      CHECK(HelpErrors(Replaced(wrong, pair.key_at, typo.size(), advised))
                .empty());
    }
  }
}

// What people write instead of a value.
std::vector<std::string> MistakesIn(const std::string& value) {
  const std::size_t blank = value.find(' ');
  const std::string number = value.substr(0, blank);
  std::vector<std::string> mistakes = {number + "%",
                                       number + " %",
                                       number + " kg",
                                       number + " sec",
                                       number + " h",
                                       number + " seconds",
                                       number + "cm",
                                       number + " metres",
                                       number + " degrees",
                                       number + "\u00B0",
                                       number + " Nm",
                                       number + " kHz",
                                       number + " N/mm",
                                       number + " m/s^2",
                                       number + " parsec",
                                       number + " m/s",
                                       number + " percent",
                                       "\"" + value + "\"",
                                       "'" + number + "'",
                                       number,
                                       "yes",
                                       "Flase",
                                       "1e3",
                                       "100.0",
                                       "1_000",
                                       "many",
                                       "80%",
                                       "50",
                                       "[1, 2]",
                                       "{a: 1}",
                                       "~",
                                       "-"};
  for (const std::string& typo : TyposOf(value)) mistakes.push_back(typo);
  return mistakes;
}

TEST_CASE("A wrong value is one error, and its advice is accepted",
          "[yaml][help]") {
  const std::string text = WholeExperiment();
  std::size_t advices = 0;
  std::size_t tried = 0;
  for (const Pair& pair : PairsOf(text)) {
    if (pair.value.empty() || pair.key == "inclined" || pair.key == "hot")
      continue;
    for (const std::string& mistake : MistakesIn(pair.value)) {
      // Each is tried with other keys.
      if (tried++ % (2 * test::kSparser) != 0) continue;
      const std::string wrong =
          Replaced(text, pair.value_at, pair.value.size(), mistake);
      const auto errors = HelpErrors(wrong);
      INFO(pair.key << ": " << mistake << " for " << pair.value);
      if (errors.empty()) continue;
      INFO(errors[0].message << " / " << errors[0].help);
      REQUIRE(errors.size() == 1);
      const std::string advised = Advised(errors[0]);
      for (const Fix& fix : errors[0].fixes) CHECK(fix.replacement == advised);
      if (advised.empty()) continue;
      ++advices;
      const auto left =
          HelpErrors(Replaced(text, pair.value_at, pair.value.size(), advised));
      INFO((left.empty() ? "" : left[0].message));
      // Another duration may not go with the rest of the file.
      CHECK((left.empty() ||
             (left.size() == 1 && left[0].code == Code::kMisfit)));
    }
  }
  CHECK(advices > 600 / test::kSparser);
}

TEST_CASE("Units, percentages and quotes always get advice", "[yaml][help]") {
  const std::string text = WholeExperiment();
  for (const Pair& pair : PairsOf(text)) {
    const std::size_t blank = pair.value.find(' ');
    const std::string number = pair.value.substr(0, blank);
    const bool is_number =
        !number.empty() &&
        number.find_first_not_of("0123456789.e+-") == std::string::npos;
    if (!is_number) continue;
    for (const std::string& mistake :
         {number + " kg", number + " %", "\"" + pair.value + "\""}) {
      INFO(pair.key << ": " << mistake);
      const auto errors =
          HelpErrors(Replaced(text, pair.value_at, pair.value.size(), mistake));
      REQUIRE(errors.size() == 1);
      INFO(errors[0].message << " / " << errors[0].help);
      if (pair.key.starts_with("plsc_") && errors[0].code == Code::kOutOfRange)
        continue;
      CHECK(!Advised(errors[0]).empty());
    }
  }
}

TEST_CASE("A percentage is a share", "[yaml][help]") {
  const auto help = [](const std::string& text) {
    const auto errors = HelpErrors(text);
    return errors.size() == 1 ? errors[0].help : "";
  };
  CHECK(help("mutation: 80%\n") == "write '0.8'");
  CHECK(help("mutation: 80 percent\n") == "write '0.8'");
  CHECK(help("mutation: 80\n") == "write '0.8' for 80 %");
  CHECK(help("mutation: 180%\n") == "write it as in '0.8'");
  CHECK(help("mutation: 0,75\n") == "write '0.75'");
  CHECK(help("population: 80%\n") == "write it as in '100'");
  CHECK(help("population: 1e3\n") == "write '1000'");
  CHECK(help("move_to_new: yes\n") == "write 'True'");
}

TEST_CASE("A key that is there cannot be meant by another", "[yaml][help]") {
  const auto errors = HelpErrors("seeds: 1\nseed: 2\n");
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].help.starts_with("known here: "));
  // Each key once, though some are asked for several times.
  CHECK(errors[0].help.find("generations") ==
        errors[0].help.rfind("generations"));
  CHECK(errors[0].help.find("states,") == errors[0].help.rfind("states,"));
}

TEST_CASE("Unknown ground is one error", "[yaml][help]") {
  for (const char* terrain :
       {"flatt", "moon", "{moon: 1}", "{tiltd: 5 deg}", "{flat: {}}",
        "{tilted: 5}", "{}", "{tilted: 5 deg, steps: {}}"}) {
    const Source source(
        "scenario.yaml",
        fmt::format("seasons:\n  - {{terrain: flat}}\n  - {{terrain: {}}}\n",
                    terrain));
    const auto scenario = ParseScenario(source);
    INFO(terrain);
    CHECK(scenario.diagnostics().size() == 1);
  }
}

TEST_CASE("A misspelt study is one error", "[yaml][help]") {
  const auto count = [](const std::string& text) {
    const Source source("study.yaml", text);
    return ParseStudy(source).diagnostics().size();
  };
  CHECK(count("experiments: {a: {}}\n") == 0);
  CHECK(count("experimnts: {a: {}}\n") == 1);
  CHECK(count("base: {populaton: 5}\nexperiments: {a: {}, b: {}}\n") == 1);
  CHECK(count("base: {population: 5%}\nexperiments: {a: {}, b: {}}\n") == 1);
  CHECK(count("base: {states: 5}\nexperiments: {a: {}, b: {}}\n") == 1);
}

}  // namespace
}  // namespace plsc
