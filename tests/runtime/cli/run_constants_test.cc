// Whatever takes a robot out of a run takes it with the run's constants. Runs
// are drawn with a value of its own for every constant, which the test knows
// from the text that it wrote.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "runtime/pages/page.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;
using test::TemporaryFolder;

/// A constant of YAML, drawn from a range in which robots live.
struct Constant {
  const char* name;
  const char* unit;
  double low, high;
};

const Constant kPhysics[] = {
    {"step", " s", 0.0021, 0.004},
    {"gravity", " m/s2", 1, 15},
    {"world_erp", "", 0.11, 0.3},
    {"world_cfm", "", 1e-6, 9e-6},
    {"friction", "", 0.2, 0.9},
    {"slip", " m/s/N", 0.011, 0.02},
    {"robot_kp", " N/m", 10000, 80000},
    {"robot_kd", " N s/m", 100000, 900000},
    {"ground_kp", " N/m", 100000, 900000},
    {"ground_kd", " N s/m", 10000, 80000},
    {"damping", "", 0.0002, 0.0009},
    {"correcting_speed", " m/s", 50, 90},
    {"surface_layer", " m", 2e-8, 9e-8},
    {"max_speed", " m/s", 60, 90},
    {"max_spin", " rad/s", 600, 900},
    {"max_solver_failures", "", 0.2, 0.9},
};
const Constant kServo[] = {
    {"range", " rad", 0.3, 1.2},       {"gain", " 1/s", 1, 5},
    {"max_speed", " rad/s", 0.4, 0.9}, {"max_torque", " N m", 0.2, 0.9},
    {"update_rate", " Hz", 9, 30},
};

using Values = std::map<std::string, std::string>;

/// A run that is unlike the default in everything, and what it says.
struct DrawnRun {
  Values physics, servo;
  std::string friction;  ///< of the second season, which has its own
  int max_modules = 0;
  bool is_continuous = false;
  std::string yaml;
};

class Drawing {
 public:
  explicit Drawing(unsigned seed) : random_(seed) {}

  DrawnRun Draw() {
    DrawnRun run;
    run.max_modules = 4 + static_cast<int>(random_() % 4);
    run.is_continuous = random_() % 2 == 0;
    const std::string physics = DrawMap(kPhysics, run.physics);
    const std::string servo = DrawMap(kServo, run.servo);
    run.friction = Number(0.2, 0.9);
    run.yaml = fmt::format(
        "plsc_experiment: 1\nseed: {}\npopulation: 3\noffspring: 2\n"
        "generations: 2\nmax_modules: {}\niterations: {}\nmove_to_new: True\n"
        "max_terms: 3\nmax_rules: 1\nmax_groups: 3\nscenario:\n"
        "  lives: {}\n  controller: open_loop\n  start_clearance: 3 mm\n"
        "  physics: {{{}, solver: iterative, solver_iterations: 33, "
        "max_direct_links: 7}}\n"
        "  servo: {{{}, refresh: late}}\n  seasons:\n"
        "    - {{name: ice, terrain: flat, duration: 0.4 s, start_height: 7 cm,"
        " senses: {{inclined: True}}}}\n"
        "    - {{name: hill, terrain: {{tilted: 9 deg}}, duration: 0.4 s, "
        "physics: {{friction: {}}}}}\n",
        random_() % 1000, run.max_modules, 1 + random_() % 2,
        run.is_continuous ? "continuous" : "independent", physics, servo,
        run.friction);
    return run;
  }

 private:
  std::string Number(double low, double high) {
    const double share = static_cast<double>(random_() % 1000) / 1000;
    return fmt::format("{:.6g}", low + share * (high - low));
  }

  template <typename Constants>
  std::string DrawMap(const Constants& constants, Values& values) {
    std::string text;
    for (const Constant& one : constants) {
      values[one.name] = Number(one.low, one.high);
      text += fmt::format("{}{}: {}{}", text.empty() ? "" : ", ", one.name,
                          values[one.name], one.unit);
    }
    return text;
  }

  std::mt19937 random_;
};

bool Holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Of the first robot of a stored run, in each format.
class Exports {
 public:
  Exports(std::string run, std::string season)
      : run_(std::move(run)), season_(std::move(season)) {}

  std::string As(const std::string& format) const {
    const auto ran =
        RunPlsc({"export", run_, "1", "--env", season_, "--to", format});
    INFO(ran.err);
    CHECK(ran.exit == 0);
    return ran.out;
  }
  std::string WarningOf(const std::string& format) const {
    return RunPlsc({"export", run_, "1", "--env", season_, "--to", format}).err;
  }

 private:
  std::string run_, season_;
};

void CheckJson(const Json& robot, const DrawnRun& run, const Values& physics,
               bool is_hill) {
  for (const auto& [name, value] : physics) {
    INFO(name);
    CHECK(robot["physics"][name] == std::stod(value));
  }
  CHECK(robot["physics"]["solver"] == "iterative");
  CHECK(robot["physics"]["solver_iterations"] == 33);
  CHECK(robot["physics"]["max_direct_links"] == 7);
  const Json& servo = robot["controller"]["servo"];
  for (const auto& [name, value] : run.servo) {
    INFO(name);
    CHECK(servo[name] == std::stod(value));
  }
  CHECK(servo["refresh"] == "late");
  CHECK(robot["controller"]["controller"] == "open_loop");
  for (const Json& joint : robot["joints"]) {
    CHECK(joint["upper"] == std::stod(run.servo.at("range")));
    CHECK(joint["actuator"]["max_torque"] ==
          std::stod(run.servo.at("max_torque")));
  }
  CHECK(robot["ground"]["type"] == (is_hill ? "tilted" : "flat"));
  if (!is_hill)
    CHECK(robot["start"]["position"][2] == 0.07);
  else
    CHECK(robot["ground"]["normal"][1].get<double>() ==
          Approx(-std::sin(std::acos(-1) / 20)));
  // Later seasons of a life begin at rest, on the slope; others from 3 cm.
  if (is_hill && run.is_continuous)
    CHECK(robot["start"]["axes"][1][2] == robot["ground"]["normal"][1]);
}

void CheckTexts(const Exports& exports, const DrawnRun& run,
                const Values& physics) {
  const auto servo = [&](const char* name) { return run.servo.at(name); };
  const std::string mjcf = exports.As("mjcf");
  const std::string both = "\"-{0} {0}\"";
  CHECK(Holds(mjcf, "timestep=\"" + physics.at("step") + "\""));
  CHECK(Holds(mjcf, "gravity=\"0 0 -" + physics.at("gravity") + "\""));
  CHECK(Holds(mjcf, "friction=\"" + physics.at("friction") + " "));
  for (const auto& [attribute, name] :
       {std::pair{"range=", "range"}, std::pair{"ctrlrange=", "max_speed"},
        std::pair{"forcerange=", "max_torque"}})
    CHECK(
        Holds(mjcf, attribute + fmt::format(fmt::runtime(both), servo(name))));
  const std::string sdf = exports.As("sdf");
  for (const auto& [element, name] :
       {std::pair{"max_step_size", "step"}, std::pair{"mu", "friction"},
        std::pair{"slip1", "slip"}, std::pair{"cfm", "world_cfm"},
        std::pair{"erp", "world_erp"}, std::pair{"linear", "damping"},
        std::pair{"contact_surface_layer", "surface_layer"},
        std::pair{"contact_max_correcting_vel", "correcting_speed"}})
    CHECK(Holds(sdf, fmt::format("<{0}>{1}</{0}>", element, physics.at(name))));
  CHECK(Holds(sdf, "<gravity>0 0 -" + physics.at("gravity") + "</gravity>"));
  CHECK(Holds(sdf, "<type>quick</type>"));
  const std::string urdf = exports.As("urdf");
  CHECK(Holds(urdf, "<mu1>" + physics.at("friction") + "</mu1>"));
  CHECK(Holds(urdf, "gravity " + physics.at("gravity") + " m/s2"));
  if (Holds(urdf, "revolute"))
    CHECK(Holds(urdf, fmt::format("upper=\"{}\" effort=\"{}\" velocity=\"{}\"",
                                  servo("range"), servo("max_torque"),
                                  servo("max_speed"))));
  const std::string header = exports.As("controller-c");
  for (const auto& [name, value] : run.servo)
    CHECK(Holds(header, "_" + name + " = " + value));
  CHECK(Holds(header, "plsc ran `controller: open_loop`"));
  CHECK(Holds(header, "refresh: late"));
  const Json controller = Json::parse(exports.As("controller-json"));
  for (const auto& [name, value] : run.servo)
    CHECK(controller["servo"][name] == std::stod(value));
  for (const char* format : {"urdf", "yaml"}) {
    const std::string warning = exports.WarningOf(format);
    CHECK(Holds(warning, "gravity " + physics.at("gravity") + " m/s2"));
    CHECK(std::count(warning.begin(), warning.end(), '\n') == 1);
  }
  for (const char* format : {"mjcf", "sdf", "json", "controller-c"})
    CHECK(exports.WarningOf(format).empty());
}

/// Modules but sensors, by number.
std::set<std::string> ModulesOf(const Json& robot) {
  std::set<std::string> modules;
  for (const Json& link : robot["links"])
    for (const Json& box : link["boxes"])
      if (box["part"] != "sensor")
        modules.insert(box["module"].get<std::string>());
  return modules;
}

/// What the other commands say of the robot, against what the run has stored.
void CheckCommands(const std::string& run, const DrawnRun& drawn,
                   const Json& stored, const TemporaryFolder& folder) {
  const auto lived = RunPlsc({"simulate", run, "1", "--format", "json",
                              "--trajectory", folder / "samples"});
  INFO(lived.err);
  std::istringstream lines(lived.out);
  for (const Json& season : stored["seasons"]) {
    std::string line;
    REQUIRE(std::getline(lines, line));
    const Json now = Json::parse(line);
    CHECK(now["state_hash"] == season["state_hash"]);
    CHECK(now["fitness"] == season["fitness"]);
  }
  CHECK(Holds(test::ReadFile(folder / "samples/scenario.yaml"),
              "gravity: " + drawn.physics.at("gravity") + " m/s2"));
  CHECK(RunPlsc({"replay", run, "--all"}).exit == 0);
  if (HasPages()) {
    const std::string page = folder / "page.html";
    // A life other than the stored one would be a warning.
    CHECK(RunPlsc({"view", run, "1", "-o", page}).err ==
          "wrote " + page + "\n");
    const std::string explained = folder / "explained.html";
    CHECK(RunPlsc({"view", "--explain", run, "1", "-o", explained}).exit == 0);
    CHECK(Holds(test::ReadFile(explained),
                fmt::format("max_modules {}", drawn.max_modules)));
  }
}

void CheckSeason(const std::string& run, const DrawnRun& drawn,
                 const Json& season) {
  const std::string name = season["season"];
  INFO(name);
  Values physics = drawn.physics;
  if (name == "hill") physics["friction"] = drawn.friction;
  const Exports exports(run, name);
  const Json robot = Json::parse(exports.As("json"));
  CheckJson(robot, drawn, physics, name == "hill");
  CheckTexts(exports, drawn, physics);
  const std::set<std::string> modules = ModulesOf(robot);
  const auto size = modules.size();
  CHECK(size <= static_cast<std::size_t>(drawn.max_modules));
  CHECK(size == season["body_descriptors"]["absolute_size"]);
  const std::string picture = RunPlsc({"draw", run, "1", "--env", name}).out;
  for (const std::string& module : modules) {
    CHECK(Holds(picture, " " + module + " "));
    CHECK(RunPlsc({"why", run, "1", "--module", module, "--env", name}).exit ==
          0);
  }
  CHECK(RunPlsc({"why", run, "1", "--env", name, "--module",
                 std::to_string(drawn.max_modules + 1)})
            .exit == 1);
}

TEST_CASE("A robot of a run goes nowhere without the run's constants",
          "[run_constants]") {
  constexpr unsigned kSeed = 20261130;
  Drawing drawing(kSeed);
  // Of both kinds of life.
  std::set<bool> kinds;
  for (int i = 0; i < 4 && kinds.size() < 2; ++i) {
    const DrawnRun drawn = drawing.Draw();
    if (!kinds.insert(drawn.is_continuous).second) continue;
    INFO("seed " << kSeed << ", draw " << i << "\n" << drawn.yaml);
    const TemporaryFolder folder;
    const std::string run = folder / "run.sqlite";
    const auto evolved = RunPlsc({"evolve", folder.Write("e.yaml", drawn.yaml),
                                  "-o", run, "--quiet", "--jobs", "1"});
    INFO(evolved.err);
    REQUIRE(evolved.exit == 0);
    const Json stored =
        Json::parse(RunPlsc({"show", run, "1", "--format", "json"}).out);
    REQUIRE(stored["seasons"].size() == 2);
    for (const Json& season : stored["seasons"])
      CheckSeason(run, drawn, season);
    CheckCommands(run, drawn, stored, folder);
  }
  CHECK(kinds.size() == 2);
}

}  // namespace
}  // namespace plsc
