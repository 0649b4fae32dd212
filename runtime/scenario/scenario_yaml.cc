// Reading and printing are held to each other: what PrintScenario writes reads
// back to an equal scenario, with every value written out. Stores, keys and
// requests depend on it, so a value that is read and not printed is a defect
// that shows only later, as equal keys of different simulations.

#include "runtime/scenario/scenario_yaml.h"

#include <fmt/format.h>

#include <numbers>
#include <set>

#include "grammar/enum_names.h"
#include "grammar/number.h"
#include "grammar/suggest.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/scenario/scenario_terrain.h"
#include "runtime/text/yaml_text.h"

namespace plsc {

namespace {

constexpr int kFormat = 1;  // of scenario files, the value of plsc_scenario

// Each is a simulation of every robot, and a column of reports.
constexpr std::size_t kMaxSeasons = 1000;

// Limits of plausible lives; max_steps is the one that counts.
constexpr Quantity kDuration = {Dimension::kTime, 0, 1e6, true};
constexpr Quantity kSampleInterval = {Dimension::kTime, 0, 60, true};
constexpr Quantity kStartHeight = {Dimension::kLength, 0, 10};
constexpr Quantity kClearance = {Dimension::kLength, 0, 1};
constexpr Quantity kThreshold = {Dimension::kAngle, 0, std::numbers::pi};
constexpr Quantity kSettling = {Dimension::kTime, 0, 60};

// Of start_height: on the ground instead of above it.
constexpr const char* kResting = "resting";

constexpr EnumNames<Lives, 2> kLivesNames{
    {{Lives::kIndependent, "independent"}, {Lives::kContinuous, "continuous"}}};

constexpr EnumNames<Plasticity, 2> kPlasticityNames{
    {{Plasticity::kLifelong, "lifelong"},
     {Plasticity::kMorphogenesis, "morphogenesis"}}};

constexpr EnumNames<MeasuredPoint, 2> kMeasuredNames{
    {{MeasuredPoint::kMassCentre, "mass_centre"},
     {MeasuredPoint::kCore, "core"}}};

constexpr EnumNames<Sensing, 2> kSensingNames{
    {{Sensing::kImu, "imu"}, {Sensing::kGiven, "given"}}};

std::map<std::string, std::string> ReadSenses(YamlMap map) {
  std::map<std::string, std::string> senses;
  for (const YamlMap::Entry& entry : map.TakeAll()) {
    const auto text = entry.value.Text("what is sensed, such as True");
    if (!text) continue;
    // YAML's other spellings; a clause of the language knows only these two.
    const bool is_true = *text == "true" || *text == "TRUE";
    if (is_true || *text == "false" || *text == "FALSE")
      entry.value.Report(
          Code::kUnknownWord,
          fmt::format("expected True or False, found '{}'", *text),
          fmt::format("write '{}', as in a clause",
                      is_true ? "True" : "False"));
    senses[entry.key] = *text;
  }
  return senses;
}

// Trajectories go to files of this name.
bool IsFileName(std::string_view name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return name.find_first_not_of(kAllowed) == std::string_view::npos &&
         !name.starts_with('.');
}

std::optional<double> ReadStartHeight(const YamlValue& value) {
  if (value.is_scalar() && !value.is_quoted() && value.text() == kResting)
    return std::nullopt;
  const std::vector<std::string_view> words = {kResting};
  if (value.is_scalar() && Suggest(value.text(), words)) {
    value.Report(Code::kUnknownWord,
                 fmt::format("expected a length or {}, found '{}'", kResting,
                             value.text()),
                 fmt::format("did you mean '{}'?", kResting), kResting);
    return std::nullopt;
  }
  return value.Number(kStartHeight);
}

Season ReadSeason(const YamlValue& value, Profile profile,
                  const PhysicsPatch& shared) {
  Season season;
  std::optional<YamlMap> map = value.Map("a season");
  if (!map) return season;
  Terrain terrain;
  if (const auto written = map->Find("terrain"))
    terrain = ReadTerrain(*written);
  season = ProfileSeason(profile, terrain);
  season.physics = Patched(season.physics, shared);
  season.name =
      map->Text("name", std::string(NameIn(kTerrainNames, terrain.type)));
  if (!IsFileName(season.name))
    map->Find("name")->Report(
        Code::kUnknownWord,
        "expected a name of letters, digits, '_', '-' and '.'",
        "files are called after seasons");
  season.duration = map->Number("duration", season.duration, kDuration);
  if (const auto height = map->Find("start_height"))
    season.start_height = ReadStartHeight(*height);
  if (const auto physics = map->Find("physics"))
    if (auto physics_map = physics->Map("physical constants"))
      season.physics =
          Patched(season.physics, ReadPhysics(std::move(*physics_map)));
  if (const auto senses = map->Find("senses"))
    if (auto senses_map = senses->Map("what is sensed, by state"))
      season.senses = ReadSenses(std::move(*senses_map));
  map->Close();
  return season;
}

std::vector<Season> ReadSeasons(YamlMap& map, Profile profile,
                                const PhysicsPatch& shared) {
  std::vector<Season> seasons;
  const auto value =
      map.Need("seasons", "write 'seasons: [{terrain: flat, senses: {...}}]'");
  if (!value) return seasons;
  const auto items = value->List("seasons");
  if (!items) return seasons;
  if (items->empty())
    value->Report(Code::kMisfit, "expected at least one season, found none");
  if (items->size() > kMaxSeasons) {
    value->Report(Code::kMisfit,
                  fmt::format("a scenario has at most {} seasons, "
                              "found {}",
                              kMaxSeasons, items->size()));
    return seasons;
  }
  std::set<std::string> names;
  for (const YamlValue& item : *items) {
    const std::size_t errors = item.error_count();
    Season season = ReadSeason(item, profile, shared);
    // A season that is wrong may be called after what it is not.
    if (item.error_count() == errors && !names.insert(season.name).second)
      item.Report(Code::kMisfit,
                  fmt::format("two seasons are called '{}'", season.name),
                  "give each its own 'name'");
    seasons.push_back(std::move(season));
  }
  return seasons;
}

// Of a season: as many as the longest one has of the default interval. A
// robot's trajectory is held in memory, some 200 bytes a sample.
constexpr double kMaxSamples = 5e6;

// All tell of the first season that is wrong: one number is wrong for all.
void CheckSampling(YamlMap& map, const Scenario& scenario) {
  const YamlValue place = map.Find("sample_interval").value_or(map.place());
  for (const Season& season : scenario.seasons) {
    if (scenario.sample_interval < season.physics.step)
      return place.Report(
          Code::kMisfit,
          fmt::format("samples every {} s are closer than the steps "
                      "of season '{}', {} s",
                      scenario.sample_interval, season.name,
                      season.physics.step));
    if (scenario.sample_interval > season.duration)
      return place.Report(
          Code::kMisfit,
          fmt::format("samples every {} s are further apart than "
                      "season '{}' is long, {} s",
                      scenario.sample_interval, season.name, season.duration));
    const double samples = season.duration / scenario.sample_interval;
    if (samples > kMaxSamples)
      return place.Report(
          Code::kMisfit,
          fmt::format("samples every {} s are {:.0f} of season '{}', "
                      "{} s, more than {:.0f}",
                      scenario.sample_interval, samples, season.name,
                      season.duration, kMaxSamples),
          "a greater 'sample_interval' takes less memory");
  }
}

// What a core may take to settle before anything is lived: some seconds of
// computing that no signal ends.
constexpr double kMaxSettlingSteps = 1e6;

/// Before any robot waits for it.
void CheckSettling(YamlMap& map, const Scenario& scenario) {
  if (scenario.sensing != Sensing::kImu) return;
  const YamlValue place = map.Find("imu").value_or(map.place());
  for (const Season& season : scenario.seasons) {
    const double steps = scenario.imu.settling / season.physics.step;
    if (steps > kMaxSettlingSteps)
      return place.Report(
          Code::kMisfit,
          fmt::format("the IMU settles for {} s, which are {:.0f} steps of "
                      "season '{}', more than {:.0f}",
                      scenario.imu.settling, steps, season.name,
                      kMaxSettlingSteps),
          "let it settle for a shorter time ('imu: {settling: ...}'), or make "
          "the steps longer");
  }
}

/// Likewise.
void CheckLengths(YamlMap& map, const Scenario& scenario) {
  const YamlValue place = map.Find("max_steps").value_or(map.place());
  for (const Season& season : scenario.seasons) {
    const double steps = season.duration / season.physics.step;
    if (steps > scenario.max_steps)
      return place.Report(
          Code::kMisfit,
          fmt::format("season '{}' of {} s takes {:.0f} steps, more "
                      "than max_steps, {}",
                      season.name, season.duration, steps, scenario.max_steps),
          "a longer season needs a greater 'max_steps'");
  }
}

std::string PrintSenses(const std::map<std::string, std::string>& senses) {
  std::vector<std::string> items;
  for (const auto& [name, value] : senses) {
    const LeadingNumber<double> number = ReadNumber<double>(value);
    const bool is_number = number.kind == LeadingNumber<double>::Kind::kFits &&
                           number.length == value.size();
    // Values of bool states are YAML's, too.
    const bool is_bare = is_number || value == "True" || value == "False";
    items.push_back(fmt::format("{}: {}", PrintYamlText(name),
                                is_bare ? value : PrintYamlText(value)));
  }
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

std::string PrintSeason(const Season& season, const PhysicsOptions& shared,
                        const std::string& blanks) {
  const std::string height =
      season.start_height
          ? PrintQuantity(*season.start_height, Dimension::kLength)
          : kResting;
  std::string text;
  text += fmt::format("{}- name: {}\n", blanks, PrintYamlText(season.name));
  text +=
      fmt::format("{}  terrain: {}\n", blanks, PrintTerrain(season.terrain));
  text += fmt::format("{}  duration: {}\n", blanks,
                      PrintQuantity(season.duration, Dimension::kTime));
  text += fmt::format("{}  start_height: {}\n", blanks, height);
  if (season.physics != shared)
    text += fmt::format("{}  physics: {}\n", blanks,
                        PrintPhysicsChanges(season.physics, shared));
  text += fmt::format("{}  senses: {}\n", blanks, PrintSenses(season.senses));
  return text;
}

void ReadLimits(YamlMap& map, Scenario& scenario) {
  constexpr int kMost = 2000000000;  // a year of computing
  scenario.max_steps = map.Int("max_steps", scenario.max_steps, 1, kMost);
  scenario.max_links = map.Int("max_links", scenario.max_links, 1, kMost);
}

void ReadImu(YamlMap& map, ImuOptions& imu) {
  const auto value = map.Find("imu");
  if (!value) return;
  auto keys = value->Map("constants of the IMU");
  if (!keys) return;
  imu.threshold = keys->Number("threshold", imu.threshold, kThreshold);
  imu.settling = keys->Number("settling", imu.settling, kSettling);
  keys->Close();
}

}  // namespace

Scenario ReadScenario(YamlMap& map, Profile otherwise) {
  const std::size_t errors = map.place().error_count();
  const Profile profile = map.Choice("profile", otherwise, kProfileNames);
  Scenario scenario = ProfileScenario(profile);
  scenario.name = map.Text("name", "");
  scenario.lives = map.Choice("lives", scenario.lives, kLivesNames);
  scenario.plasticity =
      map.Choice("plasticity", scenario.plasticity, kPlasticityNames);
  PhysicsPatch physics;
  if (const auto written = map.Find("physics"))
    if (auto physics_map = written->Map("physical constants"))
      physics = ReadPhysics(std::move(*physics_map));
  if (const auto servo = map.Find("servo"))
    if (auto servo_map = servo->Map("constants of the servo"))
      scenario.servo = ReadServo(std::move(*servo_map), scenario.servo);
  scenario.controller =
      map.Choice("controller", scenario.controller, kControllerNames);
  scenario.measured = map.Choice("measured", scenario.measured, kMeasuredNames);
  scenario.sensing = map.Choice("sensing", scenario.sensing, kSensingNames);
  ReadImu(map, scenario.imu);
  ReadLimits(map, scenario);
  scenario.sample_interval =
      map.Number("sample_interval", scenario.sample_interval, kSampleInterval);
  scenario.start_clearance =
      map.Number("start_clearance", scenario.start_clearance, kClearance);
  scenario.seasons = ReadSeasons(map, profile, physics);
  ReadTargets(map, scenario);
  const auto fitness = map.Find("fitness");
  if (fitness) ReadFitness(*fitness, scenario);
  map.Close();
  if (map.place().error_count() == errors) {
    CheckSampling(map, scenario);
    CheckLengths(map, scenario);
    CheckSettling(map, scenario);
    if (const auto problem = CheckTargets(scenario))
      fitness->Report(problem->code, problem->message, problem->help);
    if (const auto problem = CheckEngines(scenario))
      map.Find("physics")
          .value_or(map.Find("seasons").value_or(map.place()))
          .Report(problem->code, problem->message, problem->help);
  }
  return scenario;
}

std::string PrintScenarioKeys(const Scenario& scenario, int indent) {
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  const std::string deeper = blanks + "  ";
  std::string text;
  const auto add = [&](const char* key, const auto& value) {
    text += fmt::format("{}{}: {}\n", blanks, key, value);
  };
  // Of the first season; others say what differs.
  const PhysicsOptions physics = scenario.seasons.empty()
                                     ? PhysicsOptions{}
                                     : scenario.seasons.front().physics;
  if (!scenario.name.empty()) add("name", PrintYamlText(scenario.name));
  add("profile", NameIn(kProfileNames, scenario.profile));
  add("lives", NameIn(kLivesNames, scenario.lives));
  add("plasticity", NameIn(kPlasticityNames, scenario.plasticity));
  text += fmt::format("{}seasons:\n", blanks);
  for (const Season& season : scenario.seasons)
    text += PrintSeason(season, physics, deeper);
  if (!scenario.targets.empty()) add("targets", PrintTargets(scenario.targets));
  // What is printed is in the keys of simulations, which must stay as they
  // were.
  if (HasOwnFitness(scenario)) text += PrintFitness(scenario, blanks);
  add("sample_interval",
      PrintQuantity(scenario.sample_interval, Dimension::kTime));
  add("start_clearance",
      PrintQuantity(scenario.start_clearance, Dimension::kLength));
  add("controller", NameIn(kControllerNames, scenario.controller));
  add("measured", NameIn(kMeasuredNames, scenario.measured));
  add("sensing", NameIn(kSensingNames, scenario.sensing));
  add("imu",
      fmt::format("{{threshold: {}, settling: {}}}",
                  PrintQuantity(scenario.imu.threshold, Dimension::kAngle),
                  PrintQuantity(scenario.imu.settling, Dimension::kTime)));
  add("max_steps", scenario.max_steps);
  add("max_links", scenario.max_links);
  text += fmt::format("{}physics:\n", blanks);
  text += PrintPhysics(physics, deeper);
  text += fmt::format("{}servo:\n", blanks);
  text += PrintServo(scenario.servo, deeper);
  return text;
}

Result<Scenario> ParseScenario(const Source& yaml, Profile otherwise) {
  const YamlFile file(yaml);
  Scenario scenario;
  if (std::optional<YamlMap> root = file.Root("a scenario")) {
    root->Int("plsc_scenario", kFormat, kFormat, kFormat);
    scenario = ReadScenario(*root, otherwise);
  }
  if (!file.diagnostics().empty()) return file.diagnostics();
  return scenario;
}

std::string PrintScenario(const Scenario& scenario) {
  return fmt::format("plsc_scenario: {}\n{}", kFormat,
                     PrintScenarioKeys(scenario, 0));
}

}  // namespace plsc
