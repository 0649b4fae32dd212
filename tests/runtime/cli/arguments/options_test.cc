#include "runtime/cli/arguments/options.h"

#include <catch2/catch.hpp>

#include "runtime/cli/arguments/arguments.h"
#include "runtime/cli/arguments/command_description.h"

namespace plsc {
namespace {

enum class Colour : std::uint8_t { kRed, kGreen };

struct PaintCommand {
  std::string file = "none";
  std::vector<std::string> words;
  int coats = 1;
  std::optional<int> jobs;
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> other;
  double scale = 1;
  std::optional<double> limit;
  std::string taken;
  bool dry = false;
  Colour colour = Colour::kRed;
  std::string kind;
};

std::string CheckShort(const std::string& text) {
  return text.size() < 5 ? "" : "expected a short word";
}

void Add(cli::Options& options, PaintCommand& command) {
  options.Group("house", "Keep a house", "  plsc house paint x");
  options.Command("paint", "Paint a house");
  options.Add("FILE", command.file, "what").Required();
  options.Add("--words", command.words, "some").SplitAt(',').Check(CheckShort);
  options.Add("-c,--coats", command.coats, "how many").Range(1, 3);
  const cli::Option jobs = options.Add("--jobs", command.jobs, "at once");
  options.Add("--seed", command.seed, "a seed").NotNegative();
  options.Add("--other", command.other, "a seed").Excludes(jobs);
  options.Add("--scale", command.scale, "size").Range(0.5, 2.0).ValueName("S");
  options.Add("--limit", command.limit, "size").Needs(jobs);
  options.Add(
      "--take", [&](const std::string& word) { command.taken = word + "!"; },
      "a word");
  options.Flag("--dry", command.dry, "do not");
  options.Choice("--colour", command.colour, "which",
                 {{"red", Colour::kRed}, {"green", Colour::kGreen}});
  options.Add("--kind", command.kind, "which").OneOf({"oil", "water"});
}

cli::Exit Run(const PaintCommand& /*command*/, cli::Io& /*io*/) {
  return cli::Exit::kFine;
}

struct CleanCommand {
  std::vector<std::string> rooms;
};

void Add(cli::Options& options, CleanCommand& command) {
  options.Group("house", "Keep a house", "  plsc house paint x");
  options.Command("clean", "Clean a house");
  options.Add("ROOM", command.rooms, "which").Count(0, 2);
}

cli::Exit Run(const CleanCommand& /*command*/, cli::Io& /*io*/) {
  return cli::Exit::kFine;
}

cli::Command Parse(std::vector<std::string> words) {
  words.insert(words.begin(), "house");
  return cli::ParseArguments(
      words, {cli::DeclareOne<PaintCommand>, cli::DeclareOne<CleanCommand>});
}

PaintCommand Painted(const std::vector<std::string>& words) {
  const cli::Command command = Parse(words);
  if (const auto* answer = command.As<cli::Answer>()) FAIL(answer->err);
  REQUIRE(command.As<PaintCommand>() != nullptr);
  return *command.As<PaintCommand>();
}

TEST_CASE("Options fill values of every type, or leave them", "[options]") {
  const PaintCommand bare = Painted({"paint", "x"});
  CHECK(bare.file == "x");
  CHECK(bare.coats == 1);
  CHECK_FALSE(bare.jobs);
  CHECK_FALSE(bare.other);
  CHECK_FALSE(bare.limit);
  CHECK(bare.colour == Colour::kRed);

  const PaintCommand all =
      Painted({"paint",   "x",      "--words", "a,b",
               "--words", "c",      "-c",      "2",
               "--jobs",  "4",      "--seed",  "18446744073709551615",
               "--scale", "0.5",    "--limit", "1.5",
               "--take",  "it",     "--dry",   "--colour",
               "green",   "--kind", "water"});
  CHECK(all.words == std::vector<std::string>{"a", "b", "c"});
  CHECK(all.coats == 2);
  CHECK(all.jobs == 4);
  CHECK(all.seed == 18446744073709551615U);
  CHECK(all.scale == 0.5);
  CHECK(all.limit == 1.5);
  CHECK(all.taken == "it!");
  CHECK(all.dry);
  CHECK(all.colour == Colour::kGreen);
  CHECK(all.kind == "water");
  CHECK(Painted({"paint", "x", "--other", "7"}).other == 7U);
}

TEST_CASE("What an option does not take is refused with its name",
          "[options]") {
  const std::vector<std::pair<std::vector<std::string>, const char*>> rows = {
      {{}, "FILE is required"},
      {{"x", "--words", "longer"}, "--words: expected a short word"},
      {{"x", "--coats", "4"}, "--coats: Value 4 not in range"},
      {{"x", "--seed", "-1"}, "--seed: Value -1 not in range"},
      {{"x", "--scale", "0.4"}, "--scale: Value 0.4 not in range"},
      {{"x", "--other", "1", "--jobs", "1"}, "--jobs excludes --other"},
      {{"x", "--limit", "1"}, "--limit requires --jobs"},
      {{"x", "--colour", "blue"}, "--colour: expected red|green, found 'blue'"},
      {{"x", "--kind", "lime"}, "--kind: "},
  };
  for (const auto& [words, message] : rows) {
    std::vector<std::string> line = words;
    line.insert(line.begin(), "paint");
    const cli::Command command = Parse(line);
    const auto* answer = command.As<cli::Answer>();
    REQUIRE(answer != nullptr);
    CHECK(answer->exit == cli::Exit::kBadUsage);
    CAPTURE(answer->err);
    CHECK(answer->err.find(message) != std::string::npos);
  }
}

TEST_CASE("Commands of a group share it", "[options]") {
  const cli::CommandDescription root = cli::DescribeCommandLine(
      {cli::DeclareOne<PaintCommand>, cli::DeclareOne<CleanCommand>});
  REQUIRE(root.commands.size() == 1);
  CHECK(root.commands[0].summary == "Keep a house");
  REQUIRE(root.commands[0].commands.size() == 2);
  CHECK(root.commands[0].commands[1].name == "house clean");
  CHECK(Parse({"clean", "a", "b"}).As<CleanCommand>()->rooms.size() == 2);
  CHECK(Parse({"clean"}).As<CleanCommand>() != nullptr);
  CHECK(Parse({"clean", "a", "b", "c"}).As<cli::Answer>() != nullptr);
  CHECK(Parse({}).As<cli::Answer>()->exit == cli::Exit::kBadUsage);
}

}  // namespace
}  // namespace plsc
