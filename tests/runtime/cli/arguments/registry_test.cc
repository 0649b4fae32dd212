// A command joins plsc at one place: one that plsc does not have is registered
// here, and found wherever commands are.

#include "runtime/cli/arguments/registry.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <ostream>
#include <sstream>

#include "runtime/cli/arguments/arguments.h"
#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/arguments/completion_script.h"
#include "runtime/cli/arguments/man_page.h"

namespace plsc {
namespace {

struct WaveCommand {
  std::string file;
  int times = 1;
};

void Add(cli::Options& options, WaveCommand& command) {
  options.Command("wave", "Wave with a limb");
  options.Add("FILE", command.file, "a genotype file").Required();
  options.Add("--times", command.times, "how often").Range(1, 9).ValueName("N");
  options.Footer("  plsc wave robot.pls");
}

cli::Exit Run(const WaveCommand& command, cli::Io& io) {
  io.out << command.file << ' ' << command.times << '\n';
  return cli::Exit::kFine;
}

cli::Registry WithWave() {
  cli::Registry registry = cli::Commands();
  registry.push_back(cli::DeclareOne<WaveCommand>);
  return registry;
}

struct Ran {
  cli::Exit exit = cli::Exit::kFine;
  std::string out;
  std::string err;
};

Ran Execute(const std::vector<std::string>& arguments,
            const cli::Registry& registry) {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const cli::Exit exit = cli::ParseArguments(arguments, registry).Execute(io);
  return {exit, out.str(), err.str()};
}

TEST_CASE("A registered command is parsed, done and explained", "[registry]") {
  const cli::Registry registry = WithWave();
  const Ran ran = Execute({"wave", "robot.pls", "--times", "3"}, registry);
  CHECK(ran.exit == cli::Exit::kFine);
  CHECK(ran.out == "robot.pls 3\n");
  CHECK(Execute({"--help"}, registry).out.find("Wave with a limb") !=
        std::string::npos);
  CHECK(Execute({"wave", "--help"}, registry).out.find("--times N") !=
        std::string::npos);
  const Ran wrong = Execute({"wave", "robot.pls", "--times", "10"}, registry);
  CHECK(wrong.exit == cli::Exit::kBadUsage);
  CHECK(wrong.err.find("plsc wave --help") != std::string::npos);
  CHECK(Execute({"wabe"}, registry).err.find("did you mean 'wave'?") !=
        std::string::npos);
  // Not registered, it is unknown.
  const Ran unknown = Execute({"wave", "robot.pls"}, cli::Commands());
  CHECK(unknown.exit == cli::Exit::kBadUsage);
  CHECK(unknown.err.find("unknown command 'wave'") != std::string::npos);
}

TEST_CASE("A registered command is described and completed, and has a page",
          "[registry]") {
  const cli::CommandDescription root = cli::DescribeCommandLine(WithWave());
  const auto all = cli::AllCommands(root);
  CHECK(all.size() == cli::AllCommands(cli::DescribeCommandLine()).size() + 1);
  const auto found = std::find_if(all.begin(), all.end(), [](const auto* one) {
    return one->name == "wave";
  });
  REQUIRE(found != all.end());
  CHECK((*found)->summary == "Wave with a limb");
  CHECK(cli::ManPage(**found, "1").find(".TH PLSC-WAVE 1 ") !=
        std::string::npos);
  CHECK(cli::ManPage(root, "1").find("plsc\\-wave") != std::string::npos);
  CHECK(cli::CompletionScript(root, cli::Shell::kBash).find("/wave)") !=
        std::string::npos);
  CHECK(cli::CompletionScript(root, cli::Shell::kZsh).find("'wave:") !=
        std::string::npos);
  CHECK(cli::CompletionScript(root, cli::Shell::kFish).find(" -a wave ") !=
        std::string::npos);
}

}  // namespace
}  // namespace plsc
