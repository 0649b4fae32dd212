// Single bits of a store flipped at random: what is read of it then is what was
// written, or a failure, never another value.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "compiler/print.h"
#include "runtime/life/season_json.h"
#include "runtime/store/export.h"
#include "runtime/store/heritage_json.h"
#include "runtime/store/run_store.h"
#include "runtime/store/verify.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

constexpr unsigned kReadSeed = 20261130;
constexpr int kIds = 32;  // of a finished run

std::string TextOf(const Individual& one) {
  std::string text = fmt::format(
      "{} {} {}\n{}\n", one.id, one.generation,
      HeritageJson(one.heritage, *one.genotype.alphabet, one.genotype.states)
          .dump(),
      Print(one.genotype));
  for (const SeasonResult& season : one.evaluation.seasons)
    text += SeasonJson(one.genotype, season) + "\n";
  return text;
}

std::string TextOf(const std::vector<SeasonEvidence>& evidence) {
  std::string text;
  for (const SeasonEvidence& season : evidence)
    text += fmt::format("{} {} {} {} {}\n", Hex(season.phenotype), season.body,
                        season.brain, Hex(season.simulation),
                        season.simulated.state_hash);
  return text;
}

std::string TextOf(const std::vector<Ancestor>& lineage) {
  std::string text;
  for (const Ancestor& one : lineage)
    text += fmt::format("{} {} {} {} {}\n", one.distance, one.id,
                        one.generation, one.heritage.parents.size(),
                        one.fitnesses.empty() ? 0 : *one.fitnesses[0]);
  return text;
}

std::string TextOf(const GenerationRecord& record) {
  std::string text = std::to_string(record.best);
  for (const int id : record.pool) text += ' ' + std::to_string(id);
  for (const int count : record.counts) text += ' ' + std::to_string(count);
  for (const int id : record.survivors) text += ' ' + std::to_string(id);
  return text;
}

std::string TextOf(const RunStatus& status) {
  // How many are evaluated is counted, not compared: --verify does that.
  return fmt::format("{} {} {}", status.generations, status.best,
                     status.is_finished);
}

/// Of everything that can be asked for; nothing where it fails.
using Answers = std::vector<std::optional<std::string>>;

template <typename T>
void Add(const Expected<T, Failure>& loaded, Answers& answers) {
  answers.push_back(loaded ? std::optional(TextOf(*loaded)) : std::nullopt);
}

Answers Ask(const std::string& path) {
  Answers answers;
  RunStore store;
  if (store.OpenForReading(path)) return answers;
  answers.emplace_back(PrintExperiment(store.experiment()) +
                       store.versions().machine);
  Add(store.Status(), answers);
  for (int id = 1; id <= kIds; ++id) Add(store.Find(id), answers);
  for (int id = 3; id <= kIds; id += 9) {
    Add(store.EvidenceOf(id), answers);
    Add(store.Lineage(id, 3), answers);
  }
  for (int g = 0; g < 5; ++g) Add(store.Generation(g), answers);
  return answers;
}

/// All files of an export; nothing if it fails.
std::optional<std::string> ExportAll(const std::string& path) {
  std::string text;
  const Sink sink = [&](std::string_view piece) {
    text += piece;
    return std::nullopt;
  };
  if (WriteJsonl(path, sink)) return std::nullopt;
  CsvExport tables;
  if (tables.Open(path) || tables.damage()) return std::nullopt;
  for (const CsvTable& table : CsvTables())
    if (tables.Write(table, sink)) return std::nullopt;
  return text;
}

/// Each line that a failing export left is one of the whole one.
void CheckLines(const std::string& path, const std::set<std::string>& whole) {
  std::string text;
  const Sink sink = [&](std::string_view piece) {
    text += piece;
    return std::nullopt;
  };
  CsvExport tables;
  if (tables.Open(path)) return;
  for (const CsvTable& table : CsvTables())
    if (table.name != "individuals")  // whose cells have lines
      (void)tables.Write(table, sink);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    CHECK(whole.contains(line));
}

std::set<std::string> LinesOf(const std::string& text) {
  std::set<std::string> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) all.insert(line);
  return all;
}

void FlipBits(int generations, int most, unsigned seed) {
  const int times = test::Sampled(most);
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  test::WriteRun(path, generations);
  const std::string whole = test::ReadBytes(path);
  const Answers expected = Ask(path);
  const std::optional<std::string> exported = ExportAll(path);
  REQUIRE(exported);
  const std::set<std::string> lines = LinesOf(*exported);
  std::mt19937 random(seed);
  int failed = 0;
  for (int i = 0; i < times; ++i) {
    const std::size_t bit = random() % (8 * whole.size());
    CAPTURE(seed, i, bit);
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    test::WriteBytes(path, bytes);
    const Answers answers = Ask(path);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      CAPTURE(k);
      if (answers[k]) CHECK(answers[k] == expected[k]);
    }
    if (const auto text = ExportAll(path)) {
      CHECK(text == exported);
    } else {
      ++failed;
      CheckLines(path, lines);
    }
  }
  // Most bits of a store mean something, which a handful of them need not show.
  CHECK(failed > (PLSC_HAS_ASAN ? 0 : times / 3));
}

}  // namespace

TEST_CASE("What is read of a finished run is what was written, or fails",
          "[reading]") {
  FlipBits(5, 60, kReadSeed);
}

TEST_CASE("Of a run under way, too", "[reading]") {
  FlipBits(3, 60, kReadSeed + 1);
}

TEST_CASE("However many bits are tried", "[reading][slow]") {
  FlipBits(5, 100, kReadSeed + 2);
  FlipBits(3, 100, kReadSeed + 3);
}

}  // namespace plsc
