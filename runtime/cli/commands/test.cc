#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <ostream>
#include <thread>

#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/testing/file.h"
#include "runtime/cli/testing/files.h"
#include "runtime/cli/testing/junit.h"
#include "runtime/cli/testing/report.h"
#include "runtime/workers/worker_count.h"

namespace plsc::cli {

namespace {

// Genotypes whose results are held at a time: enough to keep all cores busy
// between two barriers, and a hundred thousand genotypes fit into memory.
constexpr std::size_t kBatch = 512;

// Tests [begin, begin + n) on `jobs` threads; results in order.
std::vector<TestOutcome> RunBatch(const std::vector<TestPaths>& tests,
                                  std::size_t begin, std::size_t jobs,
                                  bool update) {
  std::vector<TestOutcome> outcomes(std::min(kBatch, tests.size() - begin));
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < outcomes.size(); i = next++)
      outcomes[i] = TestFile(tests[begin + i], update);
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < std::min(jobs, outcomes.size()); ++i)
    threads.emplace_back(work);
  work();
  threads.clear();  // joins
  return outcomes;
}

// Writes the golden file; a failure becomes the result of its tests.
void WriteGolden(TestOutcome& outcome) {
  if (!outcome.new_golden) return;
  TestedFile& tested = outcome.tested;
  const auto failure = WriteFile(tested.paths.golden, *outcome.new_golden);
  if (!failure) return;
  tested.cases = {{"",
                   Verdict::kError,
                   {},
                   fmt::format("error: cannot write '{}': {}\n",
                               tested.paths.golden, *failure)}};
}

Output OutputOf(const TestCommand& command) {
  Output output{command.output, OutputKind::kTestText, command.force,
                command.paths};
  if (command.format == TestFormat::kJson) output.kind = OutputKind::kTestJson;
  if (command.format == TestFormat::kJunit)
    output.kind = OutputKind::kTestJunit;
  return output;
}

// Collects what is reported while the tests run.
class TestReporter {
 public:
  TestReporter(const TestCommand& command, Io& io)
      : command_(command), io_(io) {}

  void Report(const TestedFile& tested) {
    Count(tested, totals_);
    const bool to_file = !command_.output.empty();
    const std::string text = TestText(tested);
    if (to_file || command_.format == TestFormat::kText) io_.out << text;
    if (command_.format == TestFormat::kJunit)
      report_ += JunitSuite(tested);
    else if (command_.format == TestFormat::kJson && !to_file)
      io_.out << TestJson(tested);
    else if (command_.format == TestFormat::kJson)
      report_ += TestJson(tested);
    else if (to_file)
      report_ += text;
  }

  Exit Finish() {
    const bool to_file = !command_.output.empty();
    const std::string summary = TestSummary(totals_);
    if (command_.format == TestFormat::kJunit)
      report_ = JunitDocument(totals_, report_);
    if (command_.format == TestFormat::kText) report_ += summary;
    if (to_file || command_.format == TestFormat::kText)
      io_.out << summary;
    else
      io_.out << report_;
    bool is_fine = !totals_.has_failures();
    if (to_file) {
      is_fine &= WriteOutput(OutputOf(command_), report_, io_);
    }
    return is_fine ? Exit::kFine : Exit::kBadInput;
  }

 private:
  const TestCommand& command_;
  Io& io_;
  TestTotals totals_;
  std::string report_;
};

}  // namespace

Exit Run(const TestCommand& command, Io& io) {
  if (std::find(command.paths.begin(), command.paths.end(), "-") !=
      command.paths.end()) {
    io.err << "plsc: standard input has no golden file beside it; name a file "
              "or a folder\n";
    return Exit::kBadUsage;
  }
  if (!CanWrite(OutputOf(command), io)) return Exit::kBadInput;
  const FoundTests found = FindTests(command.paths);
  TestReporter reporter(command, io);
  for (const TestedFile& problem : found.problems) reporter.Report(problem);
  const auto jobs =
      static_cast<std::size_t>(WorkerCount(command.jobs.value_or(0)));
  for (std::size_t i = 0; i < found.tests.size(); i += kBatch)
    for (TestOutcome& outcome :
         RunBatch(found.tests, i, jobs, command.update)) {
      WriteGolden(outcome);
      reporter.Report(outcome.tested);
    }
  return reporter.Finish();
}

}  // namespace plsc::cli
