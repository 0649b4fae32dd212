// Options of several values take one each time, so that no positional behind
// them is swallowed.

#include <algorithm>
#include <catch2/catch.hpp>

#include "runtime/cli/arguments/arguments.h"
#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/arguments/git.h"
#include "runtime/cli/arguments/pictures.h"
#include "runtime/cli/arguments/robots.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using test::RunPlsc;

template <typename One>
One Parsed(const std::vector<std::string>& arguments) {
  const cli::Command command = cli::ParseArguments(arguments);
  if (const auto* answer = command.As<cli::Answer>()) FAIL(answer->err);
  REQUIRE(command.As<One>() != nullptr);
  return *command.As<One>();
}

TEST_CASE("A value is one word, wherever the option stands", "[values]") {
  const auto draw = Parsed<cli::DrawCommand>(
      {"draw", "run.sqlite", "--env", "night", "best"});
  CHECK(draw.individual == "best");
  CHECK(draw.environments == std::vector<std::string>{"night"});
  const auto why = Parsed<cli::WhyCommand>(
      {"why", "--env", "flat", "quad.pls", "--module", "3"});
  CHECK(why.file == "quad.pls");
  const auto diff = Parsed<cli::DiffCommand>(
      {"diff", "--env", "a", "old.pls", "--env", "b", "new.pls"});
  CHECK(diff.files == std::vector<std::string>{"old.pls", "new.pls"});
  CHECK(diff.environments == std::vector<std::string>{"a", "b"});
  CHECK(Parsed<cli::RandomCommand>(
            {"random", "--seed", "1", "--states", "a,b", "--states", "c"})
            .states == std::vector<std::string>{"a", "b", "c"});
}

// The words that a command needs besides: its positionals and what it requires.
std::vector<std::string> Needed(const cli::CommandDescription& command,
                                const cli::OptionDescription& tried) {
  std::vector<std::string> words;
  for (const cli::OptionDescription& positional : command.positionals)
    if (positional.is_required) words.emplace_back("file");
  for (const cli::OptionDescription& option : command.options)
    if (option.is_required && option.names != tried.names) {
      words.push_back(option.names.back());
      if (!option.value.empty()) words.emplace_back("1");
    }
  return words;
}

// All at once, so that an option that somebody adds is here, too: with nothing
// behind the values to stop it, a swallowing option takes the words, and
// without it they are too many.
TEST_CASE("No option of several values swallows words", "[values]") {
  const cli::CommandDescription root = cli::DescribeCommandLine();
  int tried = 0;
  for (const cli::CommandDescription* command : cli::AllCommands(root)) {
    const bool takes_all =
        std::any_of(command->positionals.begin(), command->positionals.end(),
                    [](const auto& one) { return one.is_repeated; });
    for (const cli::OptionDescription& option : command->options) {
      if (!option.is_repeated) continue;
      ++tried;
      INFO(command->name << ' ' << option.names.back());
      CHECK(option.values_at_once == 1);
      if (takes_all) continue;
      std::vector<std::string> words = {command->name};
      for (const std::string& word : Needed(*command, option))
        words.push_back(word);
      for (const char* word : {"a=b", "one", "two", "three"})
        words.emplace_back(word);
      words.insert(words.end() - 4, option.names.back());
      const cli::Command parsed = cli::ParseArguments(words);
      CHECK(parsed.As<cli::Answer>() != nullptr);
    }
  }
  CHECK(tried >= 9);
}

TEST_CASE("Who writes several values behind an option is told how",
          "[values]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  const std::string help =
      "= help: --env takes one value each time: --env flat --env tilted\n";
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{
           {"develop", file, "--env", "flat", "tilted"},
           {"develop", "--env", "flat", "tilted", file},
           {"diff", file, file, "--env", "flat", "tilted"},
           {"stats", "--env", "flat", "tilted", file}}) {
    CAPTURE(words);
    const auto ran = RunPlsc(words);
    CHECK(ran.exit != 0);
    CHECK(ran.err.ends_with(help));
  }
  // A mistake of another kind gets no such advice.
  CHECK(RunPlsc({"draw", file, "--env", "wet", "best"}).err.find("each time") ==
        std::string::npos);
  const std::string run = test::FinishedRun().path();
  CHECK(RunPlsc({"draw", run, "--env", "hill", "best"}).exit == 0);
}

}  // namespace
}  // namespace plsc
