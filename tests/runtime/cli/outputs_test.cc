// What every command that writes replaces: all of them against all kinds of
// files, with the rule of docs/formats.md written once more.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <thread>

#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/files/png.h"
#include "runtime/pages/page.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;
using test::ReadFile;
using test::RunPlsc;

using Words = std::vector<std::string>;

/// A command line that writes one file; "@" in it is the file or its folder.
struct Writer {
  std::string kind;  ///< of what is written; equal kinds may replace each other
  Words words;
  std::string file;      ///< its name, an ending that the command wants
  bool is_kept = false;  ///< no file of this kind is replaced
  bool is_in_folder = false;
};

constexpr const char* kOneSeason =
    "seasons:\n  - {name: flat, terrain: flat, duration: 1 s, senses: "
    "{inclined: False}}\n";
constexpr const char* kOneRunStudy =
    "plsc_study: 1\nrepetitions: 1\nbase: {profile: swift, population: 2, "
    "offspring: 1, generations: 1, scenario: {seasons: [{duration: 1 s}]}}\n"
    "experiments: {one: {encoding: baseline}}\n";
constexpr const char* kRevolveText =
    "{<Alphabet.CORE_COMPONENT: 'C'>: [[[['hill', '==', True]], "
    "[[<Alphabet.CORE_COMPONENT: 'C'>, []]]]]}";

class Outputs {
 public:
  Outputs()
      : robot_(folder_.Write("robot.pls", test::kPlasticText)),
        scenario_(folder_.Write("s.yaml", kOneSeason)),
        run_(test::FinishedRun().path()),
        study_(folder_ / "study") {
    folder_.Write("old.txt", kRevolveText);
    REQUIRE(RunPlsc({"study", "run", folder_.Write("study.yaml", kOneRunStudy),
                     "-o", study_, "--quiet"})
                .exit == 0);
    REQUIRE(RunPlsc({"test", robot_, "--update"}).exit == 0);
  }

  std::vector<Writer> Writers() const {
    const Words seed = {"--seed", "1", "-o", "@"};
    const auto with = [](Words words, const Words& more) {
      words.insert(words.end(), more.begin(), more.end());
      return words;
    };
    const Words json = {"--format", "json"};
    const Words simulate = {"simulate", robot_, "--scenario", scenario_};
    std::vector<Writer> writers = {
        {"genotype", with({"random"}, seed), "a.pls", true},
        {"genotype", {"import", folder_ / "old.txt", "-o", "@"}, "a.pls", true},
        {"genotype", with({"mutate", robot_}, seed), "a.pls", true},
        {"genotype", with({"cross", robot_, robot_}, seed), "a.pls", true},
        {"genotype", {"trim", robot_, "-o", "@"}, "a.pls", true},
        {"genotype",
         {"merge", robot_, robot_, robot_, "-o", "@"},
         "a.pls",
         true},
        {"children", with(with({"mutate", robot_}, seed), json), "a.json"},
        {"children", with(with({"cross", robot_, robot_}, seed), json),
         "a.json"},
        {"svg", {"draw", robot_, "-o", "@"}, "a.svg"},
        {"svg", with(simulate, {"--svg", "@"}), "a.svg"},
        {"svg",
         {"develop", robot_, "--env", "flat", "--svg", "@"},
         "plastic-flat.svg",
         false,
         true},
        {"recording", with(simulate, {"--record", "@"}), "a.json"},
        {"trajectory", with(simulate, {"--trajectory", "@"}), "flat.csv", false,
         true},
        {"scenario", with(simulate, {"--trajectory", "@"}), "scenario.yaml",
         false, true},
        {"manual", {"man", "--all", "@"}, "plsc-why.1", false, true},
        {"test text", {"test", robot_, "-o", "@"}, "a.txt"},
        {"test json", with({"test", robot_, "-o", "@"}, json), "a.json"},
        {"junit", {"test", robot_, "-o", "@", "--format", "junit"}, "a.xml"},
        {"report", {"report", run_, "--format", "json", "-o", "@"}, "a.json"},
        {"digest", {"study", "digest", study_, "-o", "@"}, "a.json"},
        {"robot",
         {"export", robot_, "--to", "urdf", "--env", "flat", "-o", "@"},
         "a.urdf",
         true},
        {"lines", {"export", run_, "--jsonl", "-o", "@"}, "a.jsonl"},
        {"table", {"export", run_, "--csv", "@"}, "members.csv", true, true},
    };
    if (HasPages()) {
      writers.push_back({"page", {"report", run_, "-o", "@"}, "a.html"});
      writers.push_back(
          {"page", {"view", "--explain", robot_, "-o", "@"}, "a.html"});
    }
    if (cli::PngOf("<svg xmlns='http://www.w3.org/2000/svg' width='9' "
                   "height='9'/>",
                   1))
      writers.push_back({"png", {"draw", robot_, "-o", "@"}, "a.png"});
    return writers;
  }

  /// The file that the writer makes in `folder`.
  static test::Ran Run(const Writer& writer, const std::string& folder,
                       bool force) {
    Words words = writer.words;
    for (std::string& word : words)
      if (word == "@")
        word = writer.is_in_folder ? folder : folder + "/" + writer.file;
    if (force) words.emplace_back("--force");
    return RunPlsc(words);
  }

  const std::string& robot() const { return robot_; }
  const std::string& run() const { return run_; }
  /// A folder with nothing in it.
  std::string Fresh() {
    const std::string path = folder_ / std::to_string(++folders_);
    fs::create_directory(path);
    return path;
  }

 private:
  test::TemporaryFolder folder_;
  std::string robot_;
  std::string scenario_;
  std::string run_;
  std::string study_;
  int folders_ = 0;
};

struct Victim {
  std::string kind;
  std::string bytes;
  bool is_kept = false;
};

void Put(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// One file a kind, as people and commands make them.
std::vector<Victim> Victims(Outputs& world) {
  std::vector<Victim> victims = {
      {"by hand", test::kPlasticText, true},
      {"experiment", test::kTinyExperiment, true},
      {"picture of another program", "<svg xmlns=\"http://www.w3.org/\"/>",
       true},
      {"store", ReadFile(world.run()), true},
  };
  std::set<std::string> kinds;
  for (const Writer& writer : world.Writers()) {
    if (!kinds.insert(writer.kind).second) continue;
    const std::string folder = world.Fresh();
    const auto ran = Outputs::Run(writer, folder, false);
    CAPTURE(writer.kind, ran.err);
    REQUIRE(ran.exit == 0);
    victims.push_back(
        {writer.kind, ReadFile(folder + "/" + writer.file), writer.is_kept});
  }
  return victims;
}

// Reports and recordings are not the same twice: they have the time in them.
bool IsReplaced(const std::string& path, const Victim& victim) {
  return ReadFile(path) != victim.bytes;
}

TEST_CASE("Commands replace what they made, and nothing else unasked",
          "[outputs]") {
  Outputs world;
  const std::vector<Victim> victims = Victims(world);
  std::size_t turn = 0;
  for (const Writer& writer : world.Writers()) {
    for (Victim victim : victims) {
      // Otherwise equal bytes could not be told from bytes left alone.
      if (victim.kind != "store") victim.bytes += '\n';
      if (victim.kind == "test text")
        victim.bytes = "1 test of 1 file: 1 as expected\n";
      const bool is_own = victim.kind == writer.kind && !writer.is_kept;
      for (const bool is_linked : {false, true}) {
        if (!test::IsSampled(turn++) && !is_own) continue;
        INFO(writer.words[0] << " a " << writer.kind << " over a "
                             << victim.kind << (is_linked ? ", linked" : ""));
        const std::string folder = world.Fresh();
        const std::string path = folder + "/" + writer.file;
        const std::string file = is_linked ? folder + "/target" : path;
        Put(file, victim.bytes);
        if (is_linked) fs::create_symlink("target", path);
        const auto ran = Outputs::Run(writer, folder, false);
        CHECK((ran.exit == 0) == is_own);
        CHECK(IsReplaced(file, victim) == is_own);
        CHECK(fs::is_symlink(path) == is_linked);
        if (!is_own) CHECK(ran.err.find("cannot write '") != std::string::npos);
      }
    }
  }
}

TEST_CASE("What is forced is done, but for runs and what is read",
          "[outputs]") {
  Outputs world;
  for (const Writer& writer : world.Writers()) {
    INFO(writer.words[0] << " a " << writer.kind);
    const std::string folder = world.Fresh();
    const std::string path = folder + "/" + writer.file;
    const std::string by_hand = std::string(test::kPlasticText) + "# mine\n";
    Put(path, by_hand);
    CHECK(Outputs::Run(writer, folder, true).exit == 0);
    CHECK(ReadFile(path) != by_hand);
    const std::string store = ReadFile(world.run());
    Put(path, store);
    CHECK(Outputs::Run(writer, folder, true).exit != 0);
    CHECK(ReadFile(path) == store);
    fs::remove(path);
    fs::create_hard_link(world.robot(), path);
    const bool is_read = std::find(writer.words.begin(), writer.words.end(),
                                   world.robot()) != writer.words.end();
    CHECK((Outputs::Run(writer, folder, true).exit != 0) == is_read);
    CHECK(ReadFile(world.robot()) == test::kPlasticText);
  }
}

TEST_CASE("Empty files, pipes and devices are written to", "[outputs]") {
  Outputs world;
  for (const Writer& writer : world.Writers()) {
    INFO(writer.words[0] << " a " << writer.kind);
    const std::string folder = world.Fresh();
    const std::string path = folder + "/" + writer.file;
    Put(path, "");
    CHECK(Outputs::Run(writer, folder, false).exit == 0);
    CHECK_FALSE(ReadFile(path).empty());

    fs::remove_all(folder);
    fs::create_directory(folder);
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    std::string piped;
    {
      std::atomic<bool> is_read = false;
      const std::jthread reader([&] {
        piped = ReadFile(path);
        is_read = true;
      });
      CHECK(Outputs::Run(writer, folder, false).exit == 0);
      // Ends the reader of a pipe that nobody opened.
      while (!is_read) {
        const int end = ::open(path.c_str(), O_WRONLY | O_NONBLOCK);
        if (end >= 0) ::close(end);
        std::this_thread::yield();
      }
    }
    CHECK_FALSE(piped.empty());
    CHECK(fs::is_fifo(path));

    fs::remove_all(folder);
    fs::create_directory(folder);
    fs::create_symlink("/dev/null", path);
    CHECK(Outputs::Run(writer, folder, false).exit == 0);
    CHECK(fs::is_character_file("/dev/null"));

    fs::remove_all(folder);
    fs::create_directory(folder);
    fs::create_symlink("nowhere", path);
    CHECK(Outputs::Run(writer, folder, true).exit != 0);
    CHECK_FALSE(fs::exists(path));
    CHECK(fs::is_symlink(path));
  }
}

// A command that writes files and is not here is seen by its --force.
TEST_CASE("Every command that writes can be forced, and is tested",
          "[outputs]") {
  Outputs world;
  std::set<std::string> tested = {"view"};  // without pages, too
  for (const Writer& writer : world.Writers())
    tested.insert(writer.words.front() == "study" ? "study " + writer.words[1]
                                                  : writer.words.front());
  // Their outputs are stores, which nothing replaces.
  const std::set<std::string> makes_stores = {"evolve", "study run"};
  const cli::CommandDescription root = cli::DescribeCommandLine();
  std::set<std::string> forced;
  for (const cli::CommandDescription* command : cli::AllCommands(root)) {
    bool has_force = false;
    bool has_output = false;
    for (const auto& option : command->options)
      for (const std::string& name : option.names) {
        has_force |= name == "--force";
        has_output |= name == "--output";
      }
    INFO(command->name);
    CHECK((!has_output || has_force || makes_stores.count(command->name) == 1));
    if (has_force) forced.insert(command->name);
  }
  CHECK(forced == tested);
}

}  // namespace
}  // namespace plsc
