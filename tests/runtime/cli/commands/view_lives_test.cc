#include "runtime/cli/commands/view_lives.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "runtime/recording/recording_json.h"
#include "runtime/recording/view_json.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

using cli::ViewInputKind;

constexpr const char* kSecond = R"(plsc_scenario: 1
seasons:
  - {name: flat, terrain: flat, duration: 1 s, senses: {inclined: False}}
)";

struct Loaded {
  std::optional<std::vector<ViewedLife>> lives;
  std::string err;
};

Loaded Load(const cli::ViewCommand& command) {
  std::istringstream in(test::kPlasticText);
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  auto lives = cli::LoadLives(command, io);
  return {std::move(lives), err.str()};
}

TEST_CASE("inputs are what they hold, else what they are called",
          "[view_lives]") {
  const test::TemporaryFolder folder;
  const std::string run = folder / "run";
  std::filesystem::copy_file(test::FinishedRun().path(), run);
  const std::string recording = folder.Write("r", " \n{\"plsc_recording\":1}");
  const std::string genotype = folder.Write("7.pls", test::kPlasticText);
  const auto sorted = cli::SortInputs({recording, run, "3", "best", genotype,
                                       "12", "x.json", "x.sqlite", "", "-"});
  struct Row {
    const char* why;
    ViewInputKind kind;
    std::vector<std::string> robots;
  };
  const std::vector<Row> rows = {
      {"JSON", ViewInputKind::kRecording, {}},
      {"a store, and whom of it", ViewInputKind::kRun, {"3", "best"}},
      {"text", ViewInputKind::kGenotype, {}},
      {"a number behind no store", ViewInputKind::kGenotype, {}},
      {"no such file, by its name", ViewInputKind::kRecording, {}},
      {"likewise", ViewInputKind::kRun, {}},
      {"no name", ViewInputKind::kGenotype, {}},
      {"standard input", ViewInputKind::kGenotype, {}},
  };
  REQUIRE(sorted.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO(rows[i].why);
    CHECK(sorted[i].kind == rows[i].kind);
    CHECK(sorted[i].robots == rows[i].robots);
  }
}

TEST_CASE("lives are read or lived, in the order of the inputs",
          "[view_lives]") {
  const test::TemporaryFolder folder;
  const Recording recording = test::SmallRecording();
  cli::ViewCommand command;
  command.inputs = {"-", folder.Write("a.rec.json", RecordingJson(recording)),
                    test::FinishedRun().path(), "2", "best"};
  command.scenario = folder.Write("s.yaml", kSecond);
  const Loaded loaded = Load(command);
  INFO(loaded.err);
  REQUIRE(loaded.lives);
  REQUIRE(loaded.lives->size() == 4);
  const std::vector<ViewedLife>& lives = *loaded.lives;
  CHECK(lives[0].source == "standard input");
  REQUIRE(lives[0].recording.seasons.size() == 1);
  CHECK(lives[0].recording.seasons[0].motion.samples() == 51);
  CHECK(lives[1].source == "a.rec.json");
  CHECK(RecordingJson(lives[1].recording) == RecordingJson(recording));
  CHECK(lives[2].source == "run.sqlite, robot 2");
  // The stored scenario, and not the command's.
  CHECK(lives[2].recording.seasons.size() == 2);
  CHECK(lives[3].source.find("run.sqlite, robot ") == 0);
  // The same to the last bit: nothing to remark.
  CHECK(lives[2].remark.empty());
  CHECK(loaded.err.empty());
}

TEST_CASE("the best robot of a run is shown if none is named", "[view_lives]") {
  cli::ViewCommand command;
  command.inputs = {test::FinishedRun().path()};
  const Loaded loaded = Load(command);
  REQUIRE(loaded.lives);
  REQUIRE(loaded.lives->size() == 1);
  const std::string id = test::FinishedRun().summary()["best"]["id"].dump();
  CHECK(loaded.lives->front().source == "run.sqlite, robot " + id);
}

TEST_CASE("what is wrong with inputs is told, all of it", "[view_lives]") {
  const test::TemporaryFolder folder;
  struct Row {
    const char* why;
    std::vector<std::string> inputs;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"no file", {folder / "none.pls"}, "cannot read"},
      {"no recording", {folder / "none.json"}, "cannot read"},
      {"no run", {folder / "none.sqlite"}, "none.sqlite"},
      {"no such robot", {test::FinishedRun().path(), "777"}, "777"},
      {"JSON of something else",
       {folder.Write("x.json", "{\"a\": 1}")},
       "plsc_recording"},
      {"text of something else", {folder.Write("x.pls", "hello")}, "error"},
      {"a number of nothing", {"12"}, "cannot read '12'"},
      {"the second of two", {"-", folder / "none.pls"}, "cannot read"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      cli::ViewCommand command;
      command.inputs = row.inputs;
      const Loaded loaded = Load(command);
      CHECK(!loaded.lives);
      INFO(loaded.err);
      CHECK(loaded.err.find(row.message) != std::string::npos);
    }
  }
}

}  // namespace
}  // namespace plsc
