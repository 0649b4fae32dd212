#include "runtime/cli/arguments/arguments.h"

#include <catch2/catch.hpp>
#include <map>

#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/arguments/evaluate.h"
#include "runtime/cli/arguments/live.h"
#include "runtime/cli/arguments/relive.h"
#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/arguments/runs.h"
#include "runtime/cli/arguments/study.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("every command explains itself", "[arguments]") {
  const auto overview = RunPlsc({"--help"});
  CHECK(overview.exit == 0);
  for (const cli::CommandDescription& command :
       cli::DescribeCommandLine().commands) {
    INFO(command.name);
    CHECK(overview.out.find("  " + command.name + " ") != std::string::npos);
    const auto help = RunPlsc({command.name, "--help"});
    CHECK(help.exit == 0);
    CHECK(help.err.empty());
    CHECK(help.out.find("plsc " + command.name) != std::string::npos);
  }
}

TEST_CASE("the version is the project's", "[arguments]") {
  const auto ran = RunPlsc({"--version"});
  CHECK(ran.exit == 0);
  CHECK(ran.out.substr(0, 5) == "plsc ");
}

TEST_CASE("a wrong command line is a usage error and does nothing",
          "[arguments]") {
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    const char* names;  ///< what the message must name
  };
  const std::vector<Row> rows = {
      {"no command", {}, "subcommand"},
      {"unknown command", {"devlop"}, "did you mean 'develop'?"},
      {"unknown option",
       {"develop", "a.pls", "--evn", "x"},
       "did you mean '--env'?"},
      {"one file too many",
       {"develop", "a.pls", "b.pls"},
       "unexpected argument 'b.pls'"},
      {"missing file", {"develop"}, "FILE"},
      {"value missing", {"develop", "a.pls", "--env"}, "--env"},
      {"unknown format",
       {"check", "a.pls", "--format", "xml"},
       "--format: expected text|json|sarif|github, found 'xml'"},
      {"unknown word of a positional",
       {"completion", "tcsh"},
       "SHELL: expected bash|zsh|fish, found 'tcsh'"},
      {"not a number", {"random", "--seed", "one"}, "--seed"},
      {"negative seed", {"random", "--seed", "-1"}, "--seed"},
      {"seed missing", {"random"}, "--seed"},
      {"out of range",
       {"evolve", "e.yaml", "-o", "x", "--jobs", "1025"},
       "--jobs"},
      {"no output", {"evolve", "e.yaml"}, "--output"},
      {"unknown test format", {"test", "a", "--format", "xml"}, "--format"},
      {"negative jobs", {"test", "a", "--jobs", "-1"}, "--jobs"},
      {"unknown encoding",
       {"random", "--seed", "1", "--encoding", "cppn"},
       "--encoding"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto ran = RunPlsc(row.arguments);
      CHECK(ran.exit == 2);
      CHECK(ran.out.empty());
      CHECK(ran.err.find(row.names) != std::string::npos);
    }
  }
}

TEST_CASE("arguments fill one struct a command", "[arguments]") {
  const cli::Command command = cli::ParseArguments(
      {"develop", "a.pls", "--env", "x=True,y=False", "--env", "flat",
       "--format", "json", "--svg", "out", "--allow-range"});
  const auto* develop = command.As<cli::DevelopCommand>();
  REQUIRE(develop != nullptr);
  CHECK(develop->file == "a.pls");
  CHECK(develop->environments ==
        std::vector<std::string>{"x=True,y=False", "flat"});
  CHECK(develop->format == cli::OutputFormat::kJson);
  CHECK(develop->svg_folder == "out");
  CHECK(develop->allow_range);
}

template <typename One>
std::optional<int> JobsOf(const cli::Command& command) {
  return command.As<One>() == nullptr ? std::nullopt : command.As<One>()->jobs;
}

// All usable cores.
TEST_CASE("every command with --jobs takes 0", "[arguments]") {
  struct Row {
    std::vector<std::string> words;
    std::optional<int> (*jobs)(const cli::Command&);
  };
  const std::map<std::string, Row> rest = {
      {"evolve", {{"evolve", "e.yaml", "-o", "x"}, JobsOf<cli::EvolveCommand>}},
      {"replay", {{"replay", "x"}, JobsOf<cli::ReplayCommand>}},
      {"relive", {{"relive", "x"}, JobsOf<cli::ReliveCommand>}},
      {"evaluate", {{"evaluate", "--stdin"}, JobsOf<cli::EvaluateCommand>}},
      {"live", {{"live", "x"}, JobsOf<cli::LiveCommand>}},
      {"test", {{"test", "a"}, JobsOf<cli::TestCommand>}},
      {"study run",
       {{"study", "run", "s.yaml", "-o", "x"}, JobsOf<cli::StudyRunCommand>}},
  };
  std::size_t found = 0;
  const cli::CommandDescription root = cli::DescribeCommandLine();
  for (const cli::CommandDescription* one : cli::AllCommands(root))
    for (const cli::OptionDescription& option : one->options) {
      if (option.names != std::vector<std::string>{"--jobs"}) continue;
      INFO(one->name);
      ++found;
      CHECK(option.help.find("0 and default") != std::string::npos);
      REQUIRE(rest.contains(one->name));
      const Row& row = rest.at(one->name);
      std::vector<std::string> words = row.words;
      words.insert(words.end(), {"--jobs", "0"});
      CHECK(row.jobs(cli::ParseArguments(words)) == 0);
    }
  CHECK(found == rest.size());
}

}  // namespace
}  // namespace plsc
