#include "runtime/report/digest.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "runtime/report/claim_results.h"
#include "runtime/report/comparison.h"
#include "runtime/report/report.h"
#include "tests/runtime/report/reported_study.h"

namespace plsc {
namespace {

using test::ReportedStudy;

Study StudyOf(const std::string& folder) {
  const auto study = StudyIn(folder);
  REQUIRE(study);
  return *study;
}

/// Of all runs that are done.
Digest DigestOfAll(const std::vector<ReportMeasure>& measures, int every) {
  const std::string& folder = ReportedStudy::Get().folder;
  Digest digest{StudyOf(folder), measures, every, {}};
  for (const StudyRun& run : RunsOf(digest.study)) {
    auto one = DigestOf(folder, digest, run);
    REQUIRE(one);
    if (*one) AddRun(std::move(**one), digest);
  }
  return digest;
}

const Digest& AllRuns() {
  static const Digest digest = DigestOfAll(AllMeasures(), 1);
  return digest;
}

StudyReport ReportOf(const std::string& path) {
  const auto inputs = FindRuns({path});
  REQUIRE(inputs);
  return BuildReport(*inputs, AllMeasures(), {});
}

std::string Written(const std::string& text) {
  const std::string path =
      ReportedStudy::Get().scratch / "reported.digest.json";
  std::ofstream(path) << text;
  return path;
}

TEST_CASE("A digest has the runs that are done, and reads as it was written") {
  const Digest& digest = AllRuns();
  REQUIRE(digest.runs.size() == 10);  // of 12
  const std::string text = PrintDigest(digest);
  REQUIRE(text.starts_with(kDigestMark));
  const auto again = ParseDigest(Source("digest", text));
  REQUIRE(again);
  REQUIRE(PrintDigest(*again) == text);
  for (const DigestRun& run : again->runs)
    REQUIRE(run.genotype.starts_with("plsc 1"));
}

TEST_CASE("A report of a digest has the tests of the stores' report") {
  const StudyReport& stores = ReportedStudy::Get().report;
  const StudyReport digest = ReportOf(Written(PrintDigest(AllRuns())));
  REQUIRE(digest.is_thinned);
  REQUIRE(digest.experiments.size() == stores.experiments.size());
  REQUIRE(digest.seasons == stores.seasons);
  REQUIRE(digest.generation == stores.generation);
  for (const Counted of : {Counted::kMean, Counted::kBest}) {
    const auto ours = FinalsOf(digest, of);
    const auto theirs = FinalsOf(stores, of);
    REQUIRE(ours.size() == theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      REQUIRE(ours[i].values.size() == theirs[i].values.size());
      for (std::size_t k = 0; k < ours[i].values.size(); ++k)
        // Six digits of each are kept.
        REQUIRE(std::abs(ours[i].values[k].value - theirs[i].values[k].value) <=
                1e-5 * std::abs(theirs[i].values[k].value));
    }
  }
  const auto tests = TestsOf(digest, FinalsOf(digest));
  const auto their_tests = TestsOf(stores, FinalsOf(stores));
  REQUIRE(tests.size() == their_tests.size());
  REQUIRE(!tests.empty());
  for (std::size_t i = 0; i < tests.size(); ++i) {
    REQUIRE(tests[i].result.has_value() == their_tests[i].result.has_value());
    if (tests[i].result)
      REQUIRE(tests[i].result->p == their_tests[i].result->p);
  }
}

TEST_CASE("A digest keeps what is claimed, with its seals") {
  const test::Scratch scratch;
  const std::string folder = scratch / "study";
  std::filesystem::copy(ReportedStudy::Get().folder, folder,
                        std::filesystem::copy_options::recursive);
  Study study = StudyOf(folder);
  Claim claim;
  claim.name = "bigger";
  claim.measure = "size";
  claim.experiments = {"plastic", "baseline"};
  claim.seasons = {"flat"};
  study.claims = {claim};
  REQUIRE_FALSE(StateClaims(folder, study, "2026-11-30T12:00:00Z"));
  Digest digest = AllRuns();
  digest.claims = *ClaimsTextsIn(folder);
  const std::string text = PrintDigest(digest);
  const auto again = ParseDigest(Source("digest", text));
  REQUIRE(again);
  CHECK(again->claims == digest.claims);
  const auto results = ClaimResultsOf(ReportOf(Written(text)));
  REQUIRE(results.size() == 1);
  CHECK(results[0].stated.claim == claim);
  CHECK(results[0].recorded.runs == std::vector<std::size_t>{2, 3});
  CHECK(results[0].planned == std::vector<std::size_t>{3, 3});

  digest.claims[0].replace(digest.claims[0].find("bigger"), 6, "larger");
  const auto changed = ParseDigest(Source("digest", PrintDigest(digest)));
  REQUIRE_FALSE(changed);
  CHECK(changed.diagnostics()[0].message.find("changed by hand") !=
        std::string::npos);
}

TEST_CASE("A digest keeps every n-th generation and the last") {
  const Digest digest = DigestOfAll(PaperMeasures(), 3);
  const auto again = ParseDigest(Source("digest", PrintDigest(digest)));
  REQUIRE(again);
  const PopulationSummary& all = AllRuns().runs[0].reading.population;
  const PopulationSummary& some = again->runs[0].reading.population;
  REQUIRE(some.generations == all.generations);
  int left_out = 0;
  for (int i = 0; i < all.generations; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool is_kept = i % 3 == 0 || i == all.generations - 1;
    REQUIRE(std::isnan(some.of(2, 0).means[at]) == !is_kept);
    if (!is_kept) ++left_out;
  }
  REQUIRE(left_out > 0);
}

TEST_CASE("A run takes its place in a digest, whatever came first") {
  Digest digest = AllRuns();
  const std::string text = PrintDigest(digest);
  std::vector<DigestRun> runs(digest.runs.rbegin(), digest.runs.rend());
  digest.runs.clear();
  for (const DigestRun& run : runs) AddRun(run, digest);
  for (const DigestRun& run : runs) AddRun(run, digest);
  REQUIRE(PrintDigest(digest) == text);
}

TEST_CASE("A measure that a digest lacks has no numbers") {
  const Digest& digest = AllRuns();
  const auto all = AllMeasures();
  const RunReading reading = ReadingOf(digest, digest.runs[0], all);
  REQUIRE(reading.population.series.size() ==
          all.size() * reading.population.seasons.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_kept =
        std::find(digest.measures.begin(), digest.measures.end(), all[i]) !=
        digest.measures.end();
    REQUIRE(std::isnan(reading.population.of(i, 0).means[0]) == !is_kept);
  }
}

std::string WithMeasuresTwice(std::string text) {
  const std::string key = "\"measures\":[";
  const std::size_t begin = text.find(key) + key.size();
  const std::string first = text.substr(begin, text.find(',', begin) - begin);
  return text.insert(begin, first + ",");
}

TEST_CASE("A run that a digest and its store both have counts once") {
  const std::string& folder = ReportedStudy::Get().folder;
  const std::string digest = Written(PrintDigest(AllRuns()));
  Digest empty = AllRuns();
  empty.runs.clear();
  const std::string none = ReportedStudy::Get().scratch / "none.digest.json";
  std::ofstream(none) << PrintDigest(empty);
  const auto done = [](const StudyReport& report) {
    int runs = 0;
    for (const ReportRun& run : report.runs)
      runs += run.reading.state == RunState::kDone ? 1 : 0;
    return runs;
  };
  for (const std::vector<std::string>& paths :
       std::vector<std::vector<std::string>>{{digest, folder},
                                             {folder, digest},
                                             {digest, none},
                                             {none, digest},
                                             {none, folder},
                                             {digest, folder + "/plastic"}}) {
    INFO(paths[0] << ' ' << paths[1]);
    const auto inputs = FindRuns(paths);
    REQUIRE(inputs);
    const StudyReport report = BuildReport(*inputs, PaperMeasures(), {});
    REQUIRE(report.runs.size() == 12);
    REQUIRE(done(report) == 10);
  }
}

TEST_CASE("What is no digest of its study is refused with the place") {
  const std::string text = PrintDigest(AllRuns());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    const std::size_t at = other.find(from, other.find("\"runs\""));
    REQUIRE(at != std::string::npos);
    other.replace(at, from.size(), to);
    return other;
  };
  const std::vector<std::string> wrong{
      text.substr(0, text.size() / 2),
      changed("\"repetition\":1", "\"repetition\":99"),
      changed("\"repetition\":1", "\"repetition\":2"),
      changed("\"experiment\":\"plastic\"", "\"experiment\":\"plastics\""),
      changed("\"generations\":[0,", "\"generations\":["),
      changed("\"generations\":[0,", "\"generations\":[-1,"),
      changed("\"mean\":[", "\"mean\":[1,"),
      changed("\"mean\":[", "\"mean\":[\"x\","),
      changed("\"seed\":\"", "\"seed\":\"1"),
      changed("\"best\":{\"id\":", "\"best\":{\"id\":-"),
      changed("\"genotype\":\"plsc 1", "\"genotype\":\"plsc one"),
      changed("\"genotypes\":[", "\"genotypes\":[-1,"),
      changed("\"generations\":[0,", "\"generations\":[1,"),
      changed("[\n{", "[\n" +
                          text.substr(text.find("\"runs\":[\n") + 9,
                                      text.find("},\n{") -
                                          text.find("\"runs\":[\n") - 8) +
                          ",\n{"),
      "{\"plsc_digest\":2" + text.substr(kDigestMark.size() + 1),
      WithMeasuresTwice(text),
      changed("\"relived\":null", "\"relived\":[]"),
      changed("\"relived\":null", "\"relived\":{\"lives\":2}"),
  };
  for (const std::string& one : wrong) {
    INFO(one.substr(one.find("\"runs\""), 1000));
    const Source source("digest", one);
    const auto parsed = ParseDigest(source);
    REQUIRE(!parsed);
    REQUIRE(!parsed.diagnostics().empty());
    const auto inputs = FindRuns({Written(one)});
    REQUIRE(!inputs);
    REQUIRE(inputs.error().text.find("reported.digest.json:") !=
            std::string::npos);
  }
}

}  // namespace
}  // namespace plsc
