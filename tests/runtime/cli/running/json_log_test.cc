#include "runtime/cli/running/json_log.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace plsc {
namespace {

using nlohmann::ordered_json;

std::vector<ordered_json> LinesOf(const std::string& text) {
  std::vector<ordered_json> lines;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line)) lines.push_back(ordered_json::parse(line));
  return lines;
}

std::vector<std::string> KeysOf(const ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

const cli::JsonLogStart kStart = {"run.sqlite", "paper", 7, 200, 0, 20'000};

Progress Done(int generation, std::int64_t evaluations) {
  Progress progress;
  progress.generation = generation;
  progress.evaluations = evaluations;
  progress.total = 20'000;
  progress.workers = 4;
  progress.busy_workers = 3;
  progress.simulations = 30;
  progress.looked_up = 10;
  progress.simulated_seconds = 1500;
  progress.seasons = {{"flat", 0.0123, 0.001}, {"tilted", {}, {}}};
  return progress;
}

/// A log to standard output, with a clock that the test turns.
struct Watched {
  Watched() : log(out) {
    log.SetClock([this] { return now; });
    CHECK_FALSE(log.Open("-"));
  }
  std::vector<ordered_json> lines() const { return LinesOf(out.str()); }
  std::ostringstream out;
  double now = 0;
  cli::JsonLog log;
};

TEST_CASE("the log has a start, generations and an end", "[json_log]") {
  Watched watched;
  watched.log.Start(kStart);
  watched.now = 10;
  watched.log.Report(Done(0, 20));
  watched.log.Report(Done(0, 30));
  watched.log.Report(Done(1, 40));
  watched.log.Finish(Ending::kFinished, "");
  const auto lines = watched.lines();
  REQUIRE(lines.size() == 4);
  CHECK(KeysOf(lines[0]) == std::vector<std::string>{"event", "time", "seconds",
                                                     "log", "run", "experiment",
                                                     "seed", "generations",
                                                     "evaluations", "total"});
  CHECK(lines[0]["event"] == "start");
  CHECK(lines[0]["log"] == 2);
  CHECK(lines[0]["seed"] == "7");
  CHECK(lines[1]["event"] == "generation");
  CHECK(lines[1]["generation"] == 0);
  CHECK(lines[2]["generation"] == 1);
  CHECK(lines[3]["event"] == "end");
  CHECK(lines[3]["ending"] == "finished");
  CHECK(lines[3]["failure"].is_null());
  CHECK(lines[3]["evaluations"] == 40);
  for (const auto& line : lines)
    CHECK(std::regex_match(line["time"].get<std::string>(),
                           std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
}

TEST_CASE("every line of progress has the same keys", "[json_log]") {
  Watched watched;
  watched.log.Start(kStart);
  watched.now = 10;
  watched.log.Report(Done(0, 20));
  const ordered_json line = watched.lines()[1];
  CHECK(KeysOf(line) == std::vector<std::string>{
                            "event", "time", "seconds", "generation",
                            "evaluations", "total", "workers", "busy_workers",
                            "simulations", "looked_up", "looked_up_share",
                            "simulated_seconds", "evaluations_per_second",
                            "times_real", "seconds_left", "seasons"});
  CHECK(line["evaluations_per_second"] == 2.0);
  CHECK(line["times_real"] == 150.0);
  CHECK(line["looked_up_share"] == 0.25);
  CHECK(line["seconds_left"] == 19'980 / 2.0);
  CHECK(line["seasons"].dump() ==
        R"([{"season":"flat","best":0.0123,"median":0.001},)"
        R"({"season":"tilted","best":null,"median":null}])");
}

TEST_CASE("a log without progress ends too", "[json_log]") {
  Watched watched;
  watched.log.Start(kStart);
  watched.log.Finish(Ending::kFailed, "no worker");
  const auto lines = watched.lines();
  REQUIRE(lines.size() == 2);
  CHECK(lines[1]["ending"] == "failed");
  CHECK(lines[1]["failure"] == "no worker");
  CHECK(lines[1]["total"] == 20'000);
  CHECK(lines[1]["seconds_left"].is_null());
}

TEST_CASE("a line comes every ten seconds, whatever happens", "[json_log]") {
  Watched watched;
  watched.log.Start(kStart);
  watched.now = 9.9;
  watched.log.Tick();
  CHECK(watched.lines().size() == 1);
  watched.now = 10;
  watched.log.Tick();
  watched.log.Tick();
  CHECK(watched.lines().size() == 2);
  CHECK(watched.lines()[1]["event"] == "progress");
  watched.now = 11;
  watched.log.Report(Done(0, 20));
  watched.now = 20.9;
  watched.log.Report(Done(0, 21));
  CHECK(watched.lines().size() == 3);
  watched.now = 21;
  watched.log.Report(Done(0, 22));
  CHECK(watched.lines().size() == 4);
}

TEST_CASE("a file is continued, and complete after each line", "[json_log]") {
  const std::string path =
      (std::filesystem::temp_directory_path() /
       ("plsc_json_log_" + std::to_string(getpid()) + ".jsonl"))
          .string();
  std::ostringstream unused;
  for (int session = 1; session <= 2; ++session) {
    cli::JsonLog log(unused);
    REQUIRE_FALSE(log.Open(path));
    log.Start(kStart);
    log.Report(Done(0, 1));
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    CHECK(LinesOf(text.str()).size() == static_cast<std::size_t>(2 * session));
  }
  CHECK(unused.str().empty());
  std::remove(path.c_str());
}

TEST_CASE("where nothing can be written the log says why", "[json_log]") {
  std::ostringstream unused;
  cli::JsonLog none(unused);
  CHECK(none.Open("/no/such/folder/log") ==
        "cannot write to '/no/such/folder/log': No such file or directory");
  cli::JsonLog full(unused);
  REQUIRE_FALSE(full.Open("/dev/full"));
  CHECK_FALSE(full.failure());
  full.Start(kStart);
  full.Report(Done(0, 1));
  CHECK(full.failure() ==
        "cannot write to '/dev/full': No space left on device");
}

TEST_CASE("a log that was not opened writes nothing", "[json_log]") {
  std::ostringstream out;
  cli::JsonLog log(out);
  log.Start(kStart);
  log.Report(Done(0, 1));
  log.Finish(Ending::kStopped, "");
  CHECK(out.str().empty());
}

}  // namespace
}  // namespace plsc
