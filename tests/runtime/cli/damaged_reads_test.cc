// Single bits of a run's store flipped at random: every command that reads runs
// fails, or prints exactly what it prints of the whole store.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

using test::ReadFile;
using test::RunPlsc;

constexpr unsigned kDamageSeed = 20261130;

void WriteBytes(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << bytes;
}

/// What depends on the clock, the machine's load and sessions, which have no
/// checksums, is left out.
std::string Lasting(const std::string& text) {
  static const std::regex made(R"("at":"[^"]*")");
  static const std::regex work(R"("work":\{[^}]*\})");
  return std::regex_replace(std::regex_replace(text, made, ""), work, "");
}

using CommandLines = std::vector<std::vector<std::string>>;

CommandLines QuickOnes(const std::string& run, const std::string& folder) {
  return {{"show", run, "--verify"},
          {"show", run, "best"},
          {"show", run, "7", "--format", "json"},
          {"show", run, "18", "--genotype"},
          {"export", run, "--jsonl"},
          {"export", run, "--csv", folder + "/tables", "--force"},
          {"draw", run, "best"},
          {"export", run, "5", "--to", "json", "--env", "flat"},
          {"report", run, "--verify", "--format", "json", "--quiet"}};
}

CommandLines SlowOnes(const std::string& run, const std::string& folder) {
  return {{"replay", run, "12"},
          {"view", run, "9", "-o", folder + "/view.html"}};
}

/// Output and files of a command; nothing if it failed.
std::optional<std::string> OutputOf(const std::vector<std::string>& arguments,
                                    const std::string& folder) {
  const std::filesystem::path tables = folder + "/tables";
  const std::string page = folder + "/view.html";
  std::filesystem::remove_all(tables);
  std::filesystem::remove(page);
  const auto ran = RunPlsc(arguments);
  if (ran.exit != 0) {
    CHECK_FALSE(ran.err.empty());
    return std::nullopt;
  }
  std::string text = Lasting(ran.out);
  if (std::filesystem::exists(page)) text += ReadFile(page);
  if (std::filesystem::exists(tables))
    for (const char* name : {"constants", "generations", "individuals",
                             "members", "results", "robots", "run", "trials"})
      text += ReadFile((tables / (std::string(name) + ".csv")).string());
  return text;
}

void FlipBits(CommandLines (*commands_of)(const std::string&,
                                          const std::string&),
              int times, unsigned seed) {
  const test::TemporaryFolder folder;
  const std::string run = folder / "run.sqlite";
  const std::string whole = ReadFile(test::FinishedRun().path());
  WriteBytes(run, whole);
  const CommandLines commands = commands_of(run, folder.path().string());
  std::vector<std::string> expected;
  for (const auto& command : commands) {
    CAPTURE(command);
    const auto output = OutputOf(command, folder.path().string());
    REQUIRE(output);
    expected.push_back(*output);
  }
  std::mt19937 random(seed);
  for (int i = 0; i < test::Sampled(times); ++i) {
    const std::size_t bit = random() % (8 * whole.size());
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    WriteBytes(run, bytes);
    for (std::size_t k = 0; k < commands.size(); ++k) {
      CAPTURE(seed, i, bit, commands[k]);
      const auto output = OutputOf(commands[k], folder.path().string());
      if (output) CHECK(*output == expected[k]);
    }
  }
}

TEST_CASE("No command passes on a flipped bit", "[damaged_reads]") {
  FlipBits(QuickOnes, 25, kDamageSeed);
}

TEST_CASE("Nor do those that live a robot again", "[damaged_reads]") {
  FlipBits(SlowOnes, 6, kDamageSeed + 1);
}

TEST_CASE("Nor scores of them", "[damaged_reads][slow]") {
  FlipBits(QuickOnes, 75, kDamageSeed + 2);
  FlipBits(SlowOnes, 15, kDamageSeed + 3);
}

}  // namespace
}  // namespace plsc
