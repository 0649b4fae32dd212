// A run that goes by formulas of its own, from the command line to the store
// and back: with any number of workers, from a cache that other fitness filled,
// made again, replayed, relived, reported and seen.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/pages/page.h"
#include "runtime/store/result_dump.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

const char* const kOwnRun =
    "plsc_experiment: 1\nname: own\nprofile: swift\npopulation: 6\n"
    "offspring: 4\ngenerations: 3\n";
const char* const kTwoSeasons =
    "scenario:\n  targets: [{x: 0 m, y: 1 m}]\n  seasons:\n"
    "    - {terrain: flat, duration: 2 s}\n"
    "    - {terrain: {tilted: 5 deg}, duration: 2 s}\n";
const char* const kOwnFitness =
    "fitness:\n  flat: displacement - 0.01 * energy\n"
    "  tilted: \"1 / (hinge_count - 2) > 0 ? -target_distance : 3\"\n";

bool Says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("a run by formulas is the same however it is made", "[fitness]") {
  const test::TemporaryFolder folder;
  const std::string yaml = folder.Write(
      "own.yaml", std::string(kOwnRun) + kOwnFitness + kTwoSeasons);
  const auto evolve = [&](const std::string& name,
                          std::vector<std::string> options) {
    options.insert(options.begin(), {"evolve", "-o", folder / name, "--quiet",
                                     "--format", "json"});
    const auto ran = RunPlsc(options);
    INFO(ran.err);
    REQUIRE(ran.exit == 0);
    return Json::parse(ran.out);
  };
  evolve("one", {yaml, "--jobs", "1"});
  const auto dump = DumpResults(folder / "one");
  REQUIRE(dump);
  evolve("two", {yaml, "--jobs", "2"});
  CHECK(*DumpResults(folder / "two") == *dump);
  evolve("again", {"--salvage", folder / "one", "--jobs", "1"});
  CHECK(*DumpResults(folder / "again") == *dump);
  // The first generation of another fitness has the same lives.
  const std::string only_first = std::string(kOwnRun) + kTwoSeasons;
  const auto look_up = [&](const std::string& name, const char* fitness) {
    std::string text = only_first + fitness;
    text.replace(text.find("generations: 3"), 14, "generations: 1");
    return evolve(name, {folder.Write(name + ".yaml", text), "--cache",
                         folder / "cache", "--jobs", "1"});
  };
  CHECK(look_up("filled", "")["simulations"] > 0);
  const Json found = look_up("found", kOwnFitness);
  CHECK(found["simulations"] == 0);
  CHECK(found["looked_up"] == 12);

  const auto replayed = RunPlsc({"replay", folder / "one", "--all"});
  INFO(replayed.out + replayed.err);
  CHECK(replayed.exit == 0);
  CHECK(RunPlsc({"show", folder / "one", "--verify"}).exit == 0);
}

TEST_CASE("a run by formulas is told as one", "[fitness]") {
  const test::TemporaryFolder folder;
  const std::string yaml = folder.Write(
      "own.yaml", std::string(kOwnRun) + kOwnFitness + kTwoSeasons);
  const std::string told =
      "fitness flat: displacement - 0.01 * energy, tilted: 1 / (hinge_count - "
      "2) > 0 ? -target_distance : 3";
  CHECK(Says(RunPlsc({"check", yaml}).out, told));
  const std::string run = folder / "run.sqlite";
  const auto ran = RunPlsc({"evolve", yaml, "-o", run, "--jobs", "1"});
  REQUIRE(ran.exit == 0);
  CHECK_FALSE(Says(ran.err, "cm/s"));
  CHECK(Says(RunPlsc({"show", run}).out, "fitness: flat: displacement - "));
  const std::string best = RunPlsc({"show", run, "best"}).out;
  CHECK_FALSE(Says(best.substr(0, best.find("plsc 1")), "cm/s"));
  const Json json =
      Json::parse(RunPlsc({"show", run, "best", "--format", "json"}).out);
  const Json& behaviour = json["seasons"][0]["behaviour"];
  CHECK(behaviour["target_distance"].is_number());
  CHECK(behaviour["energy"].is_number());
  // Who has two joints, and only who has, is worth no number.
  const std::string lines = RunPlsc({"export", run, "--jsonl"}).out;
  CHECK(Says(lines, "undefined_fitness") ==
        Says(lines, "division by 0 in '1 / (hinge_count - 2)'"));

  const Json report =
      Json::parse(RunPlsc({"report", run, "--format", "json", "--measures",
                           "speed,fitness,energy"})
                      .out);
  CHECK(Says(report["experiments"][0]["fitness"].get<std::string>(),
             "displacement"));
  CHECK(report["measures"][0]["unit"] == "cm/s");
  CHECK(report["measures"][1]["unit"].is_null());
  CHECK(report["measures"][2]["unit"] == "J");
  CHECK(RunPlsc({"relive", run, "--lives", "2", "--jobs", "1"}).exit == 0);
  if (!HasPages()) return;
  const std::string page = folder / "page.html";
  REQUIRE(RunPlsc({"view", run, "best", "-o", page}).exit == 0);
  CHECK(Says(test::ReadFile(page), "\"targets\":[{\"x\":0.0,\"y\":1.0}]"));
}

TEST_CASE("a scenario's formulas are its own, or its experiment's",
          "[fitness]") {
  const test::TemporaryFolder folder;
  folder.Write("s.yaml", "plsc_scenario: 1\nseasons: [{}]\n");
  folder.Write("own.yaml",
               "plsc_scenario: 1\nseasons: [{}]\nfitness: energy\n");
  const auto check = [&](const std::string& text) {
    const auto checked = RunPlsc({"check", folder.Write("e.yaml", text)});
    return checked.out + checked.err;
  };
  CHECK(Says(check("plsc_experiment: 1\nscenario: own.yaml\n"),
             ", fitness energy"));
  CHECK(Says(check("plsc_experiment: 1\nscenario: s.yaml\nfitness: path\n"),
             ", fitness path"));
  CHECK(Says(check("plsc_experiment: 1\nscenario: own.yaml\nfitness: path\n"),
             "fitness is given in this file and in its own, too"));
  CHECK(Says(
      check("plsc_experiment: 1\nscenario: s.yaml\nfitness: {flat: path}\n"),
      "expected one formula for all seasons"));
  CHECK(Says(check("plsc_experiment: 1\nfitness: path\n"
                   "scenario: {fitness: energy, seasons: [{}]}\n"),
             "fitness is given here and in the scenario, too"));
  CHECK(Says(check("plsc_experiment: 1\nscenario: s.yaml\nfitness: "
                   "target_distance\n"),
             "there are no targets"));
}

}  // namespace
}  // namespace plsc
