// Every command with every kind of bad path, at every place where it takes one:
// the exit status and a message, no exception, no signal, no waiting. Each runs
// in a child, in a folder of its own; where permissions are missing not as
// root, who has them all.

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/run.h"
#include "tests/process_end.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;

/// What the child leaves where an exception came out of the command.
constexpr int kThrew = 99;
constexpr unsigned kSeconds = 60;  // of waiting for what never ends

/// Command lines that work; "SLOT:path" is a path, of the option or positional
/// of that name. Lines of a command have each of its paths at least once.
const std::vector<std::string> kLines = {
    "check FILE:r.pls --format json",
    "check FILE:r.pls --lint",
    "fix FILE:r.pls",
    "fmt FILE:r.pls",
    "lint FILE:r.pls --format json",
    "develop FILE:r.pls --svg --svg:new",
    "develop FILE:r.pls --format json --trace",
    "diff FILE:r.pls r.pls --format json",
    "draw FILE:r.pls -o --output:new.svg",
    "draw FILE:run.sqlite best",
    "merge BASE:r.pls OURS:r.pls THEIRS:r.pls -o --output:new.pls "
    "-P --path:r.pls",
    "regulate FILE:r.pls --format json",
    "simulate FILE:r.pls --scenario --scenario:s.yaml --format json --svg "
    "--svg:new.svg --record --record:new.json --trajectory --trajectory:new",
    "evaluate --stdin --scenario --scenario:s.yaml",
    "evolve EXPERIMENT:e.yaml -o --output:new.sqlite --quiet --format json "
    "--cache --cache:new.cache --json-log --json-log:new.log",
    "evolve --resume --resume:run.sqlite --quiet",
    "evolve --salvage --salvage:run.sqlite -o --output:new.sqlite --quiet",
    "show RUN:run.sqlite --format json",
    "show RUN:run.sqlite best --format json",
    "replay RUN:run.sqlite --format json",
    "relive STUDY|RUN:run.sqlite --lives 1 --quiet --format json",
    "export FILE:r.pls --to json --env flat --scenario --scenario:s.yaml -o "
    "--output:new.json",
    "export FILE:run.sqlite --csv --csv:new",
    "export FILE:run.sqlite --jsonl -o --output:new.jsonl",
    "study list STUDY:study.yaml --format json",
    "study run STUDY:study.yaml -o --output:new --cache --cache:new.cache "
    "--quiet",
    "study status FOLDER:study --format json",
    "study digest FOLDER:study -o --output:new.json --quiet",
    "live INPUT:r.pls --scenario --scenario:s.yaml --idle 0",
    "live INPUT:run.sqlite --idle 0",
    "live INPUT:study --idle 0",
    "view INPUT:r.pls --scenario --scenario:s.yaml -o --output:new.html",
    "view --explain INPUT:run.sqlite -o --output:new.html",
    "report STUDY|RUN:run.sqlite -o --output:new.html",
    "report STUDY|RUN:study --format json",
    "why FILE:r.pls --module 1 --format json",
    "test PATH:r.pls --format json",
    "test PATH:r.pls -o --output:new.txt",
    "random --seed 1 -o --output:new.pls",
    "random --experiment --experiment:e.yaml -o --output:new.pls",
    "import FILE:old.txt -o --output:new.pls",
    "mutate FILE:r.pls --seed 1 --experiment --experiment:e.yaml -o "
    "--output:new.pls",
    "mutate FILE:r.pls --seed 1 --format json",
    "cross FIRST:r.pls SECOND:r.pls --seed 1 --experiment --experiment:e.yaml "
    "-o --output:new.pls",
    "trim FILE:r.pls -o --output:new.pls",
    "trim FILE:r.pls --format json",
    "trim FILE:r.pls --scenario --scenario:s.yaml -o --output:new.pls",
    "stats FILE:r.pls --format json",
    "hash FILE:r.pls",
    "man --all --all:new",
};

constexpr const char* kRevolve =
    "{<Alphabet.CORE_COMPONENT: 'C'>: [[[['hill', '==', True]], "
    "[[<Alphabet.CORE_COMPONENT: 'C'>, []]]]]}";
constexpr const char* kScenario =
    "seasons:\n  - {name: flat, terrain: flat, duration: 1 s, senses: "
    "{inclined: False}}\n";
constexpr const char* kExperiment =
    "name: tiny\npopulation: 2\noffspring: 1\ngenerations: 1\nscenario:\n"
    "  seasons:\n    - {name: flat, terrain: flat, duration: 1 s}\n";
constexpr const char* kStudy =
    "plsc_study: 1\nname: tiny\nseed: 1\nrepetitions: 1\nbase:\n"
    "  population: 2\n  offspring: 1\n  generations: 1\n  scenario:\n"
    "    seasons:\n      - {name: flat, terrain: flat, duration: 1 s}\n"
    "experiments:\n  plastic:\n    encoding: plasticoding\n";

struct Word {
  std::string slot;  ///< empty: an argument as it is
  std::string text;
};

std::vector<Word> WordsOf(const std::string& line) {
  std::vector<Word> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos)
      words.push_back({"", word});
    else
      words.push_back({word.substr(0, colon), word.substr(colon + 1)});
  }
  return words;
}

/// A folder with all that the lines read, and with every bad path.
class World {
 public:
  World() {
    folder_.Write("r.pls", test::kPlasticText);
    folder_.Write("s.yaml", kScenario);
    folder_.Write("e.yaml", kExperiment);
    folder_.Write("study.yaml", kStudy);
    folder_.Write("old.txt", kRevolve);
    fs::copy_file(test::FinishedRun().path(), folder_ / "run.sqlite");
    REQUIRE(test::RunPlsc({"test", folder_ / "r.pls", "--update"}).exit == 0);
    REQUIRE(test::RunPlsc({"study", "run", folder_ / "study.yaml", "-o",
                           folder_ / "study", "--quiet"})
                .exit == 0);
    fs::create_directory(folder_ / "folder");
    folder_.Write("unreadable", test::kPlasticText);
    fs::permissions(folder_ / "unreadable", fs::perms::none);
    fs::create_directory(folder_ / "closed");
    folder_.Write("closed/x", test::kPlasticText);
    fs::permissions(folder_ / "closed", fs::perms::none);
    fs::create_symlink("loop", folder_ / "loop");
    fs::create_symlink("nowhere", folder_ / "dangling");
    REQUIRE(::mkfifo((folder_ / "fifo").c_str(), 0666) == 0);
    fs::permissions(folder_ / "fifo", fs::perms(0666));
    // Where a child that is nobody writes, too.
    fs::permissions(folder_.path(), fs::perms(0777));
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      kept_.insert(entry.path());
  }
  ~World() { fs::permissions(folder_ / "closed", fs::perms::owner_all); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::string path() const { return folder_.path().string(); }

  /// Removes what a command made.
  void Clean() const {
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (kept_.count(entry.path()) == 0) fs::remove_all(entry.path());
  }

 private:
  test::TemporaryFolder folder_;
  std::set<fs::path> kept_;
};

struct BadPath {
  const char* why;
  /// From the path that works.
  std::string (*made)(const std::string& good);
  bool is_nobody = false;  ///< who has no rights
  bool is_copy = false;    ///< what is good is there under the bad name, too
};

std::string EndingOf(const std::string& path) {
  return fs::path(path).extension().string();
}

const std::vector<BadPath> kBadPaths = {
    {"missing", [](const std::string& good) { return "missing" + good; }},
    {"in no folder", [](const std::string& good) { return "none/" + good; }},
    {"a folder", [](const std::string&) { return std::string("folder"); }},
    {"in a closed folder",
     [](const std::string&) { return std::string("closed/x"); }, true},
    {"a closed folder",
     [](const std::string&) { return std::string("closed"); }, true},
    {"no permission",
     [](const std::string&) { return std::string("unreadable"); }, true},
    {"in a folder that cannot be written",
     [](const std::string& good) { return "study/new" + EndingOf(good); },
     true},
    {"300 characters",
     [](const std::string& good) {
       return std::string(300, 'n') + EndingOf(good);
     }},
    {"250 characters",
     [](const std::string& good) {
       return std::string(250 - EndingOf(good).size(), 'n') + EndingOf(good);
     },
     false, true},
    {"5000 characters",
     [](const std::string& good) {
       std::string path;
       for (int i = 0; i < 50; ++i) path += std::string(99, 'n') + '/';
       return path + good;
     }},
    {"no UTF-8, missing",
     [](const std::string& good) { return "\xff\xc0" + EndingOf(good); }},
    {"no UTF-8, there",
     [](const std::string& good) { return "\xfe\xc0 é" + EndingOf(good); },
     false, true},
    {"a line end, missing",
     [](const std::string& good) { return "a\nb" + EndingOf(good); }},
    {"a line end, there",
     [](const std::string& good) { return "c\n\x1b[31m" + EndingOf(good); },
     false, true},
    {"a loop", [](const std::string&) { return std::string("loop"); }},
    {"in a loop", [](const std::string&) { return std::string("loop/x"); }},
    {"a dangling link",
     [](const std::string&) { return std::string("dangling"); }},
    {"a device", [](const std::string&) { return std::string("/dev/null"); }},
    {"a full device",
     [](const std::string&) { return std::string("/dev/full"); }},
    {"a pipe", [](const std::string&) { return std::string("fifo"); }},
    {"below a file", [](const std::string& good) { return "r.pls/" + good; }},
    {"empty", [](const std::string&) { return std::string(); }},
    {"a blank", [](const std::string&) { return std::string(" "); }},
    {"a hash", [](const std::string&) { return std::string("#"); }},
};

/// What a child did.
struct Reported {
  int status = 0;  ///< as of waitpid
  std::string out;
  std::string err;
};

[[noreturn]] void RunAsChild(const std::vector<std::string>& arguments,
                             const std::string& folder, int told,
                             bool is_nobody) {
  constexpr unsigned kNobody = 65534;
  ::alarm(kSeconds);
  int exit = kThrew;
  std::ostringstream out;
  std::ostringstream err;
  if (::chdir(folder.c_str()) != 0 ||
      (is_nobody && (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)))
    ::_exit(kThrew);
  try {
    std::istringstream in;
    cli::Io io{in, out, err};
    exit = static_cast<int>(cli::Main(arguments, io));
  } catch (const std::exception& thrown) {
    err << "threw " << thrown.what();
  }
  const std::string text = out.str() + '\0' + err.str();
  const auto written = ::write(told, text.data(), text.size());
  ::_exit(written == static_cast<ssize_t>(text.size()) ? exit : kThrew);
}

// Somebody opens the pipe for a moment, so that whoever waits for that goes on.
void TouchPipe(const std::string& path) {
  for (const int mode : {O_WRONLY, O_RDONLY}) {
    const int end = ::open(path.c_str(), mode | O_NONBLOCK);
    if (end < 0) continue;
    char drained[4096];
    while (mode == O_RDONLY && ::read(end, drained, sizeof drained) > 0) {
    }
    ::close(end);
  }
}

Reported Run(const std::vector<std::string>& arguments, const World& world,
             bool is_nobody) {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("told", "");
  const int told = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  REQUIRE(told >= 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) RunAsChild(arguments, world.path(), told, is_nobody);
  ::close(told);
  const bool has_pipe =
      std::find(arguments.begin(), arguments.end(), "fifo") != arguments.end();
  while (has_pipe && !test::EndsWithin(child, 1))
    TouchPipe(world.path() + "/fifo");
  Reported result;
  REQUIRE(::waitpid(child, &result.status, 0) == child);
  const std::string text = test::ReadFile(file);
  const std::size_t mark = text.find('\0');
  result.out = text.substr(0, mark);
  if (mark != std::string::npos) result.err = text.substr(mark + 1);
  return result;
}

// Results for scripts are JSON, whatever the names: the library refuses what is
// no UTF-8.
void CheckJson(const std::string& out) {
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);)
    CHECK(nlohmann::json::accept(line));
}

void CheckReported(const std::vector<std::string>& arguments,
                   const Reported& told) {
  CAPTURE(arguments, told.out, told.err);
  CHECK(WIFEXITED(told.status));
  if (!WIFEXITED(told.status)) return;
  const int exit = WEXITSTATUS(told.status);
  CHECK((exit == 0 || exit == 1 || exit == 2));
  if (exit != 0) CHECK_FALSE((told.err.empty() && told.out.empty()));
  const bool is_json =
      std::find(arguments.begin(), arguments.end(), "json") != arguments.end();
  const bool is_sent_elsewhere =
      std::find(arguments.begin(), arguments.end(), "-o") != arguments.end();
  if (exit == 0 && is_json && !is_sent_elsewhere) CheckJson(told.out);
}

// A path that is there under the bad name, if its kind wants that and the
// command does not make it.
void Copy(const World& world, const std::string& good, const std::string& bad) {
  const fs::path from = fs::path(world.path()) / good;
  if (fs::exists(from))
    fs::copy(from, fs::path(world.path()) / bad, fs::copy_options::recursive);
}

// Of all bad paths at every place; under AddressSanitizer, where a child takes
// many times as long, of another third at each place.
constexpr std::size_t kStep = PLSC_HAS_ASAN ? 3 : 1;

void CheckLine(const World& world, const std::vector<Word>& words,
               std::size_t place, std::size_t turn) {
  for (std::size_t b = turn % kStep; b < kBadPaths.size(); b += kStep) {
    const BadPath& bad = kBadPaths[b];
    if (bad.is_nobody && ::geteuid() != 0) continue;
    const std::string path = bad.made(words[place].text);
    std::vector<std::string> arguments;
    for (std::size_t i = 0; i < words.size(); ++i)
      arguments.push_back(i == place ? path : words[i].text);
    if (bad.is_copy) Copy(world, words[place].text, path);
    INFO(bad.why);
    CheckReported(arguments, Run(arguments, world, bad.is_nobody));
    world.Clean();
  }
}

TEST_CASE("No bad path ends a command but by its exit status", "[bad_paths]") {
  const World world;
  std::size_t turn = 0;
  for (const std::string& line : kLines) {
    const std::vector<Word> words = WordsOf(line);
    std::vector<std::string> good;
    for (const Word& word : words) good.push_back(word.text);
    INFO(line);
    const Reported told = Run(good, world, false);
    CheckReported(good, told);
    CHECK(WEXITSTATUS(told.status) == 0);
    world.Clean();
    for (std::size_t i = 0; i < words.size(); ++i)
      if (!words[i].slot.empty()) CheckLine(world, words, i, turn++);
  }
}

// The first words of a line that name its command.
std::string CommandOf(const std::string& line) {
  const std::vector<Word> words = WordsOf(line);
  return words[0].text + (words[0].text == "study" ? " " + words[1].text : "");
}

TEST_CASE("Every path of every command is tried", "[bad_paths]") {
  const cli::CommandDescription root = cli::DescribeCommandLine();
  for (const cli::CommandDescription* command : cli::AllCommands(root)) {
    std::set<std::string> tried;
    for (const std::string& line : kLines)
      if (CommandOf(line) == command->name)
        for (const Word& word : WordsOf(line)) tried.insert(word.slot);
    std::vector<cli::OptionDescription> all = command->positionals;
    all.insert(all.end(), command->options.begin(), command->options.end());
    for (const cli::OptionDescription& option : all) {
      const bool is_path = option.kind == cli::ValueKind::kGenotype ||
                           option.kind == cli::ValueKind::kFile ||
                           option.kind == cli::ValueKind::kFolder;
      if (!is_path) continue;
      const std::string name =
          option.names.empty()
              ? option.value.substr(0, option.value.find_first_of(" ."))
              : option.names.back();
      INFO(command->name << ' ' << name);
      CHECK(tried.count(name) == 1);
    }
  }
}

}  // namespace
}  // namespace plsc
