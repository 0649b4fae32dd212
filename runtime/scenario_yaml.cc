#include "runtime/scenario_yaml.h"

#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <set>

namespace plsc {

namespace {

template <typename Options>
struct NumberKey {
  const char* name;
  double Options::*field;
  Quantity quantity;
};

// Limits of plausible worlds, wide enough for any experiment; beyond them a
// number is a slip of the pen, or ODE fails.
constexpr Quantity kDuration = {Dimension::kTime, 0, 3600, true};
constexpr Quantity kSampleInterval = {Dimension::kTime, 0, 60, true};
constexpr Quantity kStartHeight = {Dimension::kLength, 0, 10};
// Beyond 89 degrees the ground is a wall.
constexpr Quantity kTilt = {Dimension::kAngle, 0, 89 * std::numbers::pi / 180};

// A field more must get its key here and in docs/experiments.md, or results
// would depend on what no file says.
static_assert(sizeof(PhysicsOptions) == 104 && sizeof(ServoOptions) == 40);

// One table for reading, printing and the round trip between them. In the
// order of PhysicsOptions, which explains the fields.
const std::vector<NumberKey<PhysicsOptions>>& PhysicsKeys() {
  using enum Dimension;
  static const std::vector<NumberKey<PhysicsOptions>> keys = {
      {"step", &PhysicsOptions::step, {kTime, 0, 0.1, true}},
      {"gravity", &PhysicsOptions::gravity, {kAcceleration, 0, 1000}},
      {"world_erp", &PhysicsOptions::world_erp, {kNumber, 0, 1}},
      {"world_cfm", &PhysicsOptions::world_cfm, {kNumber, 0, 1}},
      {"friction", &PhysicsOptions::friction, {kNumber, 0, 1000}},
      {"slip", &PhysicsOptions::slip, {kSlip, 0, 1000}},
      {"robot_kp", &PhysicsOptions::robot_kp, {kStiffness, 0, 1e12, true}},
      {"robot_kd", &PhysicsOptions::robot_kd, {kViscosity, 0, 1e12}},
      {"ground_kp", &PhysicsOptions::ground_kp, {kStiffness, 0, 1e12, true}},
      {"ground_kd", &PhysicsOptions::ground_kd, {kViscosity, 0, 1e12}},
      {"damping", &PhysicsOptions::damping, {kNumber, 0, 1}},
  };
  return keys;
}

const std::vector<NumberKey<ServoOptions>>& ServoKeys() {
  using enum Dimension;
  static const std::vector<NumberKey<ServoOptions>> keys = {
      {"range", &ServoOptions::range, {kAngle, 0, std::numbers::pi, true}},
      {"gain", &ServoOptions::gain, {kRate, 0, 1000, true}},
      {"max_speed", &ServoOptions::max_speed, {kAngularSpeed, 0, 1000, true}},
      {"max_torque", &ServoOptions::max_torque, {kTorque, 0, 1000, true}},
      {"update_rate", &ServoOptions::update_rate, {kFrequency, 0, 1e4, true}},
  };
  return keys;
}

const std::vector<std::string>& SolverNames() {
  static const std::vector<std::string> names = {"direct", "iterative"};
  return names;
}

const std::vector<std::string>& ControllerNames() {
  static const std::vector<std::string> names = {"open_loop", "coupled"};
  return names;
}

template <typename Options>
void ReadNumbers(YamlMap& map, const std::vector<NumberKey<Options>>& keys,
                 Options& options) {
  for (const NumberKey<Options>& key : keys)
    options.*key.field = map.Number(key.name, options.*key.field, key.quantity);
}

PhysicsOptions ReadPhysics(YamlMap map) {
  PhysicsOptions physics;
  physics.solver = static_cast<Solver>(map.Choice(
      "solver", static_cast<std::size_t>(physics.solver), SolverNames()));
  physics.solver_iterations =
      map.Int("solver_iterations", physics.solver_iterations, 1, 100000);
  physics.max_direct_links =
      map.Int("max_direct_links", physics.max_direct_links, 0, 100000);
  physics.max_direct_links =
      map.Int("max_direct_links", physics.max_direct_links, 0, 100000);
  ReadNumbers(map, PhysicsKeys(), physics);
  map.Close();
  return physics;
}

ServoOptions ReadServo(YamlMap map) {
  ServoOptions servo;
  ReadNumbers(map, ServoKeys(), servo);
  map.Close();
  return servo;
}

Terrain ReadTerrain(const YamlValue& value) {
  if (!value.is_map()) {
    const auto choice = value.Choice({"flat", "tilted"});
    if (choice == 1u)
      value.Report("P5106", "expected the tilt of the ground",
                   "write 'terrain: {tilted: 5 deg}'");
    return {};
  }
  YamlMap map = *value.Map("a terrain");
  Terrain terrain;
  if (const auto tilt = map.Need("tilted", "write '{tilted: 5 deg}'")) {
    terrain.type = TerrainType::kTilted;
    terrain.tilt = tilt->Number(kTilt).value_or(0);
  }
  map.Close();
  return terrain;
}

std::map<std::string, std::string> ReadSenses(YamlMap map) {
  std::map<std::string, std::string> senses;
  for (const YamlMap::Entry& entry : map.TakeAll()) {
    const auto text = entry.value.Text("what is sensed, such as True");
    if (!text) continue;
    // YAML's other spellings; a clause of the language knows only these two.
    const bool is_true = *text == "true" || *text == "TRUE";
    if (is_true || *text == "false" || *text == "FALSE")
      entry.value.Report(
          "P5107", fmt::format("expected True or False, found '{}'", *text),
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

Season ReadSeason(const YamlValue& value) {
  Season season;
  std::optional<YamlMap> map = value.Map("a season");
  if (!map) return season;
  if (const auto terrain = map->Find("terrain"))
    season.terrain = ReadTerrain(*terrain);
  const bool is_flat = season.terrain.type == TerrainType::kFlat;
  season.name = map->Text("name", is_flat ? "flat" : "tilted");
  if (!IsFileName(season.name))
    map->Find("name")->Report(
        "P5107", "expected a name of letters, digits, '_', '-' and '.'",
        "files are called after seasons");
  season.duration = map->Number("duration", season.duration, kDuration);
  season.start_height = map->Number(
      "start_height", is_flat ? kFlatStartHeight : kTiltedStartHeight,
      kStartHeight);
  if (const auto senses = map->Find("senses"))
    if (auto senses_map = senses->Map("what is sensed, by state"))
      season.senses = ReadSenses(std::move(*senses_map));
  map->Close();
  return season;
}

std::vector<Season> ReadSeasons(YamlMap& map) {
  std::vector<Season> seasons;
  const auto value =
      map.Need("seasons", "write 'seasons: [{terrain: flat, senses: {...}}]'");
  if (!value) return seasons;
  const auto items = value->List("seasons");
  if (!items) return seasons;
  if (items->empty())
    value->Report("P5108", "expected at least one season, found none");
  std::set<std::string> names;
  for (const YamlValue& item : *items) {
    Season season = ReadSeason(item);
    if (!names.insert(season.name).second)
      item.Report("P5108",
                  fmt::format("two seasons are called '{}'", season.name),
                  "give each its own 'name'");
    seasons.push_back(std::move(season));
  }
  return seasons;
}

void CheckSampling(YamlMap& map, const Scenario& scenario) {
  const YamlValue place = map.Find("sample_interval").value_or(map.place());
  if (scenario.sample_interval < scenario.physics.step)
    place.Report("P5108",
                 fmt::format("samples every {} s are closer than the steps of "
                             "{} s",
                             scenario.sample_interval, scenario.physics.step));
  for (const Season& season : scenario.seasons)
    if (scenario.sample_interval > season.duration)
      place.Report(
          "P5108",
          fmt::format("samples every {} s are further apart than "
                      "season '{}' is long, {} s",
                      scenario.sample_interval, season.name, season.duration));
}

std::string PrintSenses(const std::map<std::string, std::string>& senses) {
  std::vector<std::string> items;
  for (const auto& [name, value] : senses) {
    double number = 0;
    const char* end = value.data() + value.size();
    const auto [stop, failure] = std::from_chars(value.data(), end, number);
    const bool is_number = failure == std::errc{} && stop == end;
    items.push_back(fmt::format("{}: {}", PrintYamlText(name),
                                is_number ? value : PrintYamlText(value)));
  }
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

std::string PrintSeason(const Season& season, const std::string& blanks) {
  const std::string terrain =
      season.terrain.type == TerrainType::kFlat
          ? "flat"
          : fmt::format("{{tilted: {}}}",
                        PrintQuantity(season.terrain.tilt, Dimension::kAngle));
  std::string text;
  text += fmt::format("{}- name: {}\n", blanks, PrintYamlText(season.name));
  text += fmt::format("{}  terrain: {}\n", blanks, terrain);
  text += fmt::format("{}  duration: {}\n", blanks,
                      PrintQuantity(season.duration, Dimension::kTime));
  text += fmt::format("{}  start_height: {}\n", blanks,
                      PrintQuantity(season.start_height, Dimension::kLength));
  text += fmt::format("{}  senses: {}\n", blanks, PrintSenses(season.senses));
  return text;
}

template <typename Options>
std::string PrintNumbers(const std::vector<NumberKey<Options>>& keys,
                         const Options& options, const std::string& blanks) {
  std::string text;
  for (const NumberKey<Options>& key : keys)
    text +=
        fmt::format("{}{}: {}\n", blanks, key.name,
                    PrintQuantity(options.*key.field, key.quantity.dimension));
  return text;
}

}  // namespace

Scenario ReadScenario(YamlMap& map) {
  Scenario scenario;
  scenario.name = map.Text("name", "");
  if (const auto physics = map.Find("physics"))
    if (auto physics_map = physics->Map("physical constants"))
      scenario.physics = ReadPhysics(std::move(*physics_map));
  if (const auto servo = map.Find("servo"))
    if (auto servo_map = servo->Map("constants of the servo"))
      scenario.servo = ReadServo(std::move(*servo_map));
  scenario.controller = static_cast<ControllerMode>(
      map.Choice("controller", static_cast<std::size_t>(scenario.controller),
                 ControllerNames()));
  scenario.sample_interval =
      map.Number("sample_interval", scenario.sample_interval, kSampleInterval);
  scenario.seasons = ReadSeasons(map);
  CheckSampling(map, scenario);
  map.Close();
  return scenario;
}

std::string PrintScenarioKeys(const Scenario& scenario, int indent) {
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  const std::string deeper = blanks + "  ";
  std::string text;
  if (!scenario.name.empty())
    text += fmt::format("{}name: {}\n", blanks, PrintYamlText(scenario.name));
  text += fmt::format("{}seasons:\n", blanks);
  for (const Season& season : scenario.seasons)
    text += PrintSeason(season, deeper);
  text +=
      fmt::format("{}sample_interval: {}\n", blanks,
                  PrintQuantity(scenario.sample_interval, Dimension::kTime));
  text += fmt::format(
      "{}controller: {}\n", blanks,
      ControllerNames()[static_cast<std::size_t>(scenario.controller)]);
  const PhysicsOptions& physics = scenario.physics;
  text += fmt::format("{}physics:\n", blanks);
  text += fmt::format("{}solver: {}\n", deeper,
                      SolverNames()[static_cast<std::size_t>(physics.solver)]);
  text += fmt::format("{}solver_iterations: {}\n", deeper,
                      physics.solver_iterations);
  text +=
      fmt::format("{}max_direct_links: {}\n", deeper, physics.max_direct_links);
  text += PrintNumbers(PhysicsKeys(), physics, deeper);
  text += fmt::format("{}servo:\n", blanks);
  text += PrintNumbers(ServoKeys(), scenario.servo, deeper);
  return text;
}

}  // namespace plsc
