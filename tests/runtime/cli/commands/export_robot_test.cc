#include "runtime/cli/commands/export_robot.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/exports/robot_model.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using test::ReadFile;
using test::RunPlsc;
using test::TemporaryFolder;
using Files = std::vector<std::string>;

TEST_CASE("export --to prints the robot of one environment", "[export_robot]") {
  const TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  for (const FormatNames& format : kExportFormats) {
    const std::string name(format.name);
    INFO(name);
    const auto flat = RunPlsc({"export", file, "--env", "flat", "--to", name});
    CHECK(flat.exit == 0);
    CHECK(flat.err.empty());
    CHECK_FALSE(flat.out.empty());
    const auto tilted =
        RunPlsc({"export", file, "--env", "tilted", "--to", name});
    CHECK(tilted.out != flat.out);
    CHECK(RunPlsc({"export", "-", "--env", "flat", "--to", name},
                  test::kPlasticText)
              .out == flat.out);
    const std::string output = folder / "robot.out";
    const auto written =
        RunPlsc({"export", file, "--env", "flat", "--to", name, "-o", output});
    CHECK(written.exit == 0);
    CHECK(written.err == "wrote " + output + "\n");
    CHECK(ReadFile(output) == flat.out);
    std::filesystem::remove(output);
  }
}

TEST_CASE("export --to writes the robots of several environments into a folder",
          "[export_robot]") {
  const TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  const std::string robots = folder / "robots";
  const auto made = RunPlsc({"export", file, "--to", "mjcf", "-o", robots});
  CHECK(made.exit == 0);
  CHECK(made.out.empty());
  CHECK(made.err == "wrote " + robots + "/plastic.flat.xml\nwrote " + robots +
                        "/plastic.tilted.xml\n");
  // Beside them; an environment of the command line, twice.
  const auto more =
      RunPlsc({"export", file, "--to", "json", "-o", robots, "--env",
               "inclined=True", "--env", "inclined=True"});
  CHECK(more.exit == 0);
  CHECK(std::filesystem::exists(robots + "/plastic.inclined=True.json"));
  CHECK(std::filesystem::exists(robots + "/plastic.inclined=True-2.json"));
  // A folder that is there takes one robot, too.
  CHECK(RunPlsc({"export", file, "--to", "urdf", "--env", "flat", "-o", robots})
            .err == "wrote " + robots + "/plastic.flat.urdf\n");
}

TEST_CASE("export --to overwrites nothing without being told so",
          "[export_robot]") {
  const TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  std::filesystem::create_directory(folder / "robots");
  const std::string second = folder.Write("robots/plastic.tilted.xml", "mine");
  Files command = {"export", file, "--to", "mjcf", "-o", folder / "robots"};
  const auto refused = RunPlsc(command);
  CHECK(refused.exit == 1);
  CHECK(refused.err == "error: cannot write '" + second +
                           "': it exists; --force replaces it\n");
  CHECK(ReadFile(second) == "mine");
  CHECK_FALSE(std::filesystem::exists(folder / "robots/plastic.flat.xml"));
  command.emplace_back("--force");
  CHECK(RunPlsc(command).exit == 0);
  CHECK(ReadFile(second) != "mine");
}

TEST_CASE("export --to writes robots of runs, in the seasons they lived in",
          "[export_robot]") {
  const test::TinyRun& run = test::FinishedRun();
  const TemporaryFolder folder;
  const auto best =
      RunPlsc({"export", run.path(), "best", "--to", "json", "--env", "hill"});
  INFO(best.err);
  CHECK(best.exit == 0);
  const auto robot = nlohmann::json::parse(best.out);
  CHECK(robot["environment"] == "hill");
  CHECK(RunPlsc({"export", run.path(), "--individual", "best", "--to", "json",
                 "--env", "hill"})
            .out == best.out);
  const auto all =
      RunPlsc({"export", run.path(), "18", "--to", "sdf", "-o", folder / "18"});
  CHECK(all.exit == 0);
  CHECK(std::filesystem::exists(folder / "18/robot_18.flat.sdf"));
  CHECK(std::filesystem::exists(folder / "18/robot_18.hill.sdf"));
}

TEST_CASE("export --to writes a robot of a file in the seasons of a scenario",
          "[export_robot]") {
  const TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  const std::string scenario = folder.Write(
      "s.yaml",
      "plsc_scenario: 1\nphysics: {gravity: 3 m/s2}\nseasons:\n"
      "  - {name: hill, terrain: {tilted: 20 deg}, duration: 1 s}\n"
      "  - {name: stairs, terrain: steps, duration: 1 s}\n");
  const auto all = RunPlsc({"export", file, "--to", "json", "--scenario",
                            scenario, "-o", folder / "out"});
  CHECK(all.exit == 0);
  const auto read = [&](const char* season) {
    return nlohmann::json::parse(
        ReadFile(folder / "out/plastic." + season + ".json"));
  };
  CHECK(read("hill")["ground"]["type"] == "tilted");
  CHECK(read("hill")["joints"].size() == 1);
  CHECK(read("hill")["physics"]["gravity"] == 3);
  CHECK(read("stairs")["ground"]["boxes"].size() == 20);
  CHECK(read("stairs")["joints"].empty());
  // A run's robot may be taken elsewhere, too.
  const auto best =
      RunPlsc({"export", test::FinishedRun().path(), "best", "--to", "json",
               "--scenario", scenario, "--env", "stairs"});
  CHECK(best.exit == 0);
  CHECK(nlohmann::json::parse(best.out)["physics"]["gravity"] == 3);
  // One warning for all that a format cannot say.
  const auto urdf = RunPlsc({"export", file, "--to", "urdf", "--scenario",
                             scenario, "-o", folder / "urdf"});
  CHECK(urdf.err.find("warning: urdf has no place for what plsc simulates: in "
                      "hill the ground that is {tilted: 20 deg}, gravity 3 "
                      "m/s2; in stairs the ground") == 0);
}

TEST_CASE("export --prefix names the parts of a robot", "[export_robot]") {
  for (const char* format :
       {"mjcf", "urdf", "sdf", "json", "controller-json", "controller-c"}) {
    INFO(format);
    const auto ran = RunPlsc(
        {"export", "-", "--env", "tilted", "--to", format, "--prefix", "left-"},
        test::kPlasticText);
    CHECK(ran.exit == 0);
    CHECK(ran.out.find("left-joint_2") != std::string::npos);
    CHECK(ran.out.find("\"joint_2") == std::string::npos);
  }
}

TEST_CASE("export --to warns of robots that plsc would not simulate",
          "[export_robot]") {
  // A leg that bends back: the grid has room beside the core, space has not.
  const std::string text =
      "plsc 1 genotype tangle alphabet plasticoding 1 iterations 1\n"
      "rule C -> { C add_front A2(0.5, 1, 2, 1) move_front add_front B\n"
      "  move_front add_left B move_left add_left A2(0.5, 1, 2, 1) move_left\n"
      "  add_front B }\n";
  const auto ran = RunPlsc({"export", "-", "--to", "mjcf"}, text);
  INFO(ran.err);
  CHECK(ran.exit == 0);
  CHECK(ran.err.find("warning: in any, ") == 0);
  CHECK(ran.err.find("plsc simulates no such robot") != std::string::npos);
}

TEST_CASE("export --to says what is wrong, and writes nothing",
          "[export_robot]") {
  const TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  folder.Write("file", "text");
  std::filesystem::create_directory(folder / "taken");
  std::filesystem::create_directory(folder / "taken/plastic.flat.xml");
  struct Row {
    const char* why;
    Files arguments;
    int exit;
    const char* message;
  };
  const std::string out = folder / "out";
  const std::vector<Row> rows = {
      {"no format", {file, "--env", "flat"}, 2, "--env requires --to"},
      {"no such format", {file, "--to", "obj"}, 2, "expected mjcf|urdf|sdf"},
      {"a robot and a run",
       {file, "--to", "mjcf", "--jsonl"},
       2,
       "--to excludes --jsonl"},
      {"a prefix of no format",
       {file, "--to", "mjcf", "--prefix", "a b"},
       2,
       "expected letters, digits"},
      {"a prefix of nothing",
       {file, "--to", "yaml", "--env", "flat", "--prefix", "a"},
       2,
       "yaml has none"},
      {"no such scenario",
       {file, "--to", "mjcf", "--scenario", folder / "none.yaml"},
       1,
       "No such file"},
      {"a scenario that does not tell all",
       {file, "--to", "mjcf", "--scenario",
        folder.Write("mute.yaml",
                     "plsc_scenario: 1\nsensing: given\nseasons:\n"
                     "  - {name: flat, terrain: flat, duration: 1 s}\n")},
       1,
       "state 'inclined'"},
      {"several robots, one file",
       {file, "--to", "mjcf"},
       2,
       "2 robots, a file each (in flat, tilted)"},
      {"several robots, a file's name",
       {file, "--to", "mjcf", "-o", out + ".xml"},
       2,
       "name a folder with -o"},
      {"no such environment",
       {file, "--to", "mjcf", "--env", "wet", "-o", out},
       2,
       "environments that the file names: flat tilted"},
      {"over the input",
       {file, "--to", "yaml", "--env", "flat", "-o", file, "--force"},
       1,
       "the command reads it"},
      {"a file into no folder",
       {file, "--to", "mjcf", "--env", "flat", "-o", folder / "none/a.xml"},
       1,
       "its folder does not exist"},
      {"a folder into no folder",
       {file, "--to", "mjcf", "-o", folder / "none/robots"},
       1,
       "its folder does not exist"},
      {"a file for a folder",
       {file, "--to", "mjcf", "-o", folder / "file"},
       1,
       "it is a file"},
      {"a folder for a file",
       {file, "--to", "mjcf", "-o", folder / "taken", "--force"},
       1,
       "it is a folder"},
      {"no file", {folder / "none", "--to", "mjcf"}, 1, "No such file"},
      {"an empty file",
       {folder.Write("empty", ""), "--to", "mjcf"},
       1,
       "file is empty"},
      {"no text",
       {folder.Write("binary", std::string("\0\1\2", 3)), "--to", "mjcf"},
       1,
       "this is not a text"},
      {"cut short",
       {folder.Write("cut", "plsc 1\ngenotype x\nalphabet plastico"), "--to",
        "mjcf"},
       1,
       "error"},
      {"no such genotype", {file + "#x", "--to", "mjcf"}, 1, "no genotype 'x'"},
      {"a folder", {folder.path().string(), "--to", "mjcf"}, 1, "directory"},
      {"a run, no robot",
       {test::FinishedRun().path(), "--to", "mjcf"},
       2,
       "which of its robots?"},
      {"no such robot",
       {test::FinishedRun().path(), "99", "--to", "mjcf"},
       1,
       "99"},
  };
  const Files before = folder.Files();
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Files arguments = {"export"};
      arguments.insert(arguments.end(), row.arguments.begin(),
                       row.arguments.end());
      const auto ran = RunPlsc(arguments);
      INFO(ran.err);
      CHECK(ran.exit == row.exit);
      CHECK(ran.err.find(row.message) != std::string::npos);
      CHECK(ran.out.empty());
      CHECK(folder.Files() == before);
      CHECK(ReadFile(file) == test::kPlasticText);
    }
  }
}

TEST_CASE("Names of files hold no more of a name than file systems take",
          "[export_robot]") {
  const auto name_of = [](const char* name, const std::string& environment) {
    return cli::ExportedName(
        ModelOf({name, environment}, {LoneCore(), {}}, ExportedOptions()),
        ExportFormat::kMjcf, {});
  };
  CHECK(name_of("gecko", "hot=True,wet=False") ==
        "gecko.hot=True,wet=False.xml");
  CHECK(name_of("robot_3", "../etc <\"&'> \n") == "robot_3.___etc________.xml");
  CHECK(name_of("robot_3", std::string(1000, 'x')).size() == 112);
}

}  // namespace
}  // namespace plsc
