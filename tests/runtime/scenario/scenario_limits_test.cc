// Every number that a scenario accepts is lived to the end: each key at the
// limits that its error names, at the smallest numbers there are, and several
// keys at once. What cannot be lived is refused when it is read.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "runtime/life/evaluation.h"
#include "runtime/life/life_plan.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/scenario/scenario_yaml.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {

namespace {

/// A line of a printed scenario that has numbers: what stands before, between
/// and after them.
struct Place {
  std::size_t line = 0;
  std::string before;
  std::string unit_and_after;
};

/// The paper's scenario in short, on these grounds.
Scenario Short(Solver solver, Lives lives,
               const std::vector<TerrainType>& grounds) {
  Scenario scenario = PaperScenario();
  scenario.lives = lives;
  scenario.max_steps = 400;
  scenario.sample_interval = 0.01;
  scenario.imu.settling = 0.05;
  scenario.seasons.clear();
  for (const TerrainType type : grounds) {
    Season season;
    season.name = fmt::format("s{}", scenario.seasons.size());
    season.duration = 0.02;
    season.start_height = 0.05;
    season.terrain.type = type;
    season.terrain.tilt = 0.1;
    season.physics.solver = solver;
    scenario.seasons.push_back(season);
  }
  return scenario;
}

std::vector<TerrainType> AllGrounds() {
  using enum TerrainType;
  return {kFlat, kTilted, kRough, kSteps, kObstacles};
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Where a number begins that follows "name: ", and its end.
std::vector<Place> NumbersOf(const std::vector<std::string>& lines) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.starts_with("plsc_scenario")) continue;
    for (std::size_t at = line.find(": "); at != std::string::npos;
         at = line.find(": ", at + 1)) {
      const std::size_t begin = at + 2;
      const std::size_t end =
          std::min(line.size(), line.find_first_not_of("0123456789.e-", begin));
      if (end == begin || line[begin] == 'e') continue;
      places.push_back({i, line.substr(0, begin), line.substr(end)});
    }
  }
  return places;
}

std::string With(std::vector<std::string> lines, const Place& place,
                 const std::string& number) {
  lines[place.line] = place.before + number + place.unit_and_after;
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

/// The numbers in messages such as "expected more than 0 s and at most 0.1 s"
/// and "expected a whole number of 1 to 100000", those found left out.
std::vector<std::string> LimitsIn(const std::string& message) {
  std::vector<std::string> limits;
  std::istringstream words(message.substr(0, message.find(", found")));
  for (std::string word; words >> word;)
    if (word.find_first_not_of("0123456789.e-+") == std::string::npos)
      limits.push_back(word);
  return limits;
}

const Genotype& Walker() {
  static const Genotype genotype = test::Robot(
      "sense inclined: bool\niterations 1\n"
      "rule C -> { C add_front A1(0.5, 4, 2, 1) loop(0.5) move_front add_front "
      "A2(0.5, 2, 3, 1) move_front add_front T(0.5) move_back add_left B }\n");
  return genotype;
}

/// Lives it if it is accepted, as a run does and in one go; whether it was.
bool IsLived(const std::string& yaml) {
  INFO(yaml);
  const Result<Scenario> scenario = ParseScenario(Source("limits", yaml));
  if (!scenario) {
    CHECK_FALSE(scenario.diagnostics().front().message.empty());
    return false;
  }
  const LifePlanner planner(*scenario);
  CHECK_FALSE(planner.Plan(Walker(), {}).empty());
  for (const SeasonResult& season : Evaluate(Walker(), *scenario).seasons) {
    CHECK(season.steps <= scenario->max_steps);
    CHECK(season.outcome != Outcome::kWorkerDied);
    CHECK(season.fitness.has_value() ==
          (season.outcome == Outcome::kCompleted));
  }
  return true;
}

/// Zero, the smallest ones of their sizes, and one that is nothing special.
const std::vector<std::string>& Smallest() {
  static const std::vector<std::string> numbers = {
      "0", "5e-324", "1e-300", "1e-100", "1e-17", "1e-9", "0.01"};
  return numbers;
}

}  // namespace

TEST_CASE("Whatever number of a scenario is accepted is lived to the end",
          "[scenario][limits]") {
  const Scenario base =
      GENERATE(Short(Solver::kDirect, Lives::kIndependent, AllGrounds()),
               Short(Solver::kIterative, Lives::kContinuous,
                     {TerrainType::kTilted, TerrainType::kSteps}));
  const auto lines = LinesOf(PrintScenario(base));
  const std::vector<Place> places = NumbersOf(lines);
  CHECK(places.size() > 30);
  for (const Place& place : places) {
    std::vector<std::string> numbers = Smallest();
    for (const char* beyond : {"1e300", "-1e300", "9999999999", "-1"}) {
      const auto refused =
          ParseScenario(Source("limits", With(lines, place, beyond)));
      if (refused) continue;
      for (std::string& limit : LimitsIn(refused.diagnostics().front().message))
        numbers.push_back(std::move(limit));
    }
    int lived = 0;
    for (const std::string& number : numbers)
      lived += IsLived(With(lines, place, number));
    INFO(place.before);
    CHECK(lived > 0);
  }
}

TEST_CASE("So is whatever is accepted of several numbers",
          "[scenario][limits]") {
  std::mt19937_64 random(14);
  const auto lines = LinesOf(
      PrintScenario(Short(Solver::kDirect, Lives::kIndependent, AllGrounds())));
  const std::vector<Place> places = NumbersOf(lines);
  const std::vector<std::string> numbers = {
      "0", "5e-324", "1e-300", "1e-17", "1e-9", "1e-3", "0.1",
      "1", "20",     "60",     "1000",  "1e4",  "1e6",  "1e12"};
  int lived = 0;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    std::vector<std::string> changed = lines;
    for (int i = 0; i < 3; ++i) {
      const Place& place = places[random() % places.size()];
      changed[place.line] = place.before + numbers[random() % numbers.size()] +
                            place.unit_and_after;
    }
    lived += IsLived(fmt::format("{}\n", fmt::join(changed, "\n")));
  }
  CHECK(lived > 50);
}

// As `plsc evaluate --allow-range` lets them pass.
TEST_CASE("Arguments of a genotype that are out of range are lived, too",
          "[scenario][limits]") {
  const Scenario scenario =
      Short(Solver::kDirect, Lives::kIndependent, {TerrainType::kFlat});
  CompileOptions options;
  options.allow_out_of_range = true;
  for (const char* period : {"0", "-0.0", "-1", "5e-324", "1e-300", "1e300"})
    for (const char* other : {"4", "0", "1e308", "-1e308"}) {
      CAPTURE(period, other);
      const std::string text = fmt::format(
          "plsc 1\ngenotype odd\nalphabet plasticoding 1\niterations 1\n"
          "rule C -> {{ C add_front A1({1}, {1}, {0}, {1}) loop({1}) "
          "mutate_per({1}) move_front add_front T({1}) }}\n",
          period, other);
      const Result<Program> program = Compile(Source("odd", text), options);
      REQUIRE(program);
      const SeasonResult season =
          Evaluate(program->genotype, scenario).seasons.front();
      CHECK((season.outcome == Outcome::kCompleted ||
             season.outcome == Outcome::kUnstable));
    }
}

}  // namespace plsc
