#include "runtime/exports/controller_header.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/exports/controller_tables.h"
#include "sim/controller.h"
#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/golden_robots.h"

namespace plsc {
namespace {

/// A folder of its own that goes away with the object.
class Folder {
 public:
  Folder() {
    std::string name =
        (std::filesystem::temp_directory_path() / "plsc_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
  }

 private:
  std::filesystem::path path_;
};

std::string ReadAll(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// Updates, 8 a second: 25 s, after which most robots' movement is not yet
// periodic in the numbers' last bits.
constexpr int kUpdates = 200;

// What is touched at an update, and where the joints are: anything that
// changes, the same in both languages.
bool IsTouched(int update, std::size_t input) {
  return (update / 3 + static_cast<int>(input)) % 2 == 0;
}
double AngleAt(int update) {
  return (update % 17 - 8) / 10.0;
}

/// A program that prints, bit for bit, what each header's functions give.
std::string Harness(const std::vector<RobotModel>& models) {
  std::string program = "#include <stdio.h>\n";
  std::string calls;
  for (const RobotModel& model : models) {
    const std::string names = NamesInC(model);
    program += fmt::format("#include \"{}.h\"\n", names);
    program += fmt::format(
        R"(static void run_{0}(void) {{
  static {0}_state state;
  double outputs[{0}_SPACE], alone[{0}_SPACE];
  int touched[{0}_inputs + 1] = {{0}};
  int update, i;
  {0}_reset(&state);
  for (update = 0; update < {1}; ++update) {{
    const double time = update / {0}_update_rate;
    const double angle = (update % 17 - 8) / 10.0;
    for (i = 0; i < {0}_inputs; ++i) touched[i] = (update / 3 + i) % 2 == 0;
    {0}_update(&state, time, {0}_inputs > 0 ? touched : NULL, outputs);
    {0}_oscillate(time, alone);
    for (i = 0; i < {0}_joints; ++i)
      printf("%a %a %a %a\n", outputs[i], alone[i],
             {0}_target(outputs[i]), {0}_speed(outputs[i], angle));
  }}
  puts("{0}");
}}
)",
        names, kUpdates);
    calls += fmt::format("  run_{}();\n", names);
  }
  return program + "int main(void) {\n" + calls + "  return 0;\n}\n";
}

/// What plsc itself gives, in the program's words.
std::string Expected(const RobotModel& model) {
  const ServoOptions& servo = model.options.servo;
  const ControllerTables tables = TablesOf(model);
  Controller coupled(model.phenotype, ControllerMode::kCoupled);
  Controller alone(model.phenotype, ControllerMode::kOpenLoop);
  std::string text;
  for (int update = 0; update < kUpdates; ++update) {
    std::vector<bool> touched(model.phenotype.body.modules.size());
    for (const Node& node : model.phenotype.brain.nodes)
      for (std::size_t i = 0; i < tables.inputs.size(); ++i)
        if (tables.inputs[i] ==
            "touch_" + ModuleId(model.phenotype.body, node.module))
          touched[static_cast<std::size_t>(node.module)] = IsTouched(update, i);
    const double time = update / servo.update_rate;
    const auto outputs = coupled.Update(time, touched);
    const auto free_outputs = alone.Update(time, touched);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      char line[200];
      // The target is the angle at which the servo rests.
      const double target =
          -servo.range +
          std::clamp(outputs[i], kMinOutput, kMaxOutput) * 2 * servo.range;
      std::snprintf(line, sizeof(line), "%a %a %a %a\n", outputs[i],
                    free_outputs[i], target,
                    ServoSpeed(outputs[i], AngleAt(update), servo));
      text += line;
    }
  }
  return text + NamesInC(model) + "\n";
}

/// Odd ones, and of many robots every fifth; under names of their own.
std::vector<RobotModel> SomeModels() {
  std::vector<RobotModel> models;
  const auto& many = test::ManyModels();
  for (std::size_t i = 0; i < many.size(); i += i < 4 ? 1 : 5) {
    models.push_back(many[i]);
    models.back().name = fmt::format("{} robot", i);
    models.back().environment = "hot=True,*/ \\";
  }
  return models;
}

TEST_CASE("The C header computes what plsc does, bit for bit",
          "[controller_header]") {
  const Folder folder;
  const std::vector<RobotModel> models = SomeModels();
  std::string expected;
  for (const RobotModel& model : models) {
    folder.Write(NamesInC(model) + ".h", ControllerHeader(model));
    expected += Expected(model);
  }
  folder.Write("run.c", Harness(models));
  const std::string compile = fmt::format(
      "'{0}' -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -O2 -o "
      "'{1}' '{2}' -lm > '{3}' 2>&1",
      PLSC_C_COMPILER, folder / "run", folder / "run.c", folder / "log");
  const int compiled = std::system(compile.c_str());
  INFO(ReadAll(folder / "log"));
  REQUIRE(compiled == 0);
  const std::string run =
      fmt::format("'{}' > '{}'", folder / "run", folder / "out");
  REQUIRE(std::system(run.c_str()) == 0);
  // Not CHECK(a == b): a megabyte each.
  const bool is_equal = ReadAll(folder / "out") == expected;
  CHECK(is_equal);
  CHECK(expected.size() > 100000);
}

TEST_CASE("Names of C have letters, digits and '_' only",
          "[controller_header]") {
  struct Row {
    const char* name;
    const char* environment;
    const char* expected;
  };
  const Row rows[] = {
      {"climber", "flat", "climber_flat"},
      {"climber", "hot=True,wet=False", "climber_hot_True_wet_False"},
      {"7up", "a b", "robot_7up_a_b"},
      {"x", "gr\xc3\xbcn", "x_gr__n"},
  };
  for (const Row& row : rows)
    CHECK(NamesInC(ModelOf({row.name, row.environment}, {LoneCore(), {}},
                           ExportedOptions())) == row.expected);
}

TEST_CASE("No name ends the comment of a header", "[controller_header]") {
  const std::string header =
      ControllerHeader(ModelOf({"a",
                                "*/ int x; /* \\\n?"
                                "?/"},
                               {LoneCore(), {}}, ExportedOptions()));
  CHECK(header.find("int x") < header.find("*/"));
  CHECK(header.find('\\') == std::string::npos);
}

}  // namespace
}  // namespace plsc
