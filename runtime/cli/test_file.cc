#include "runtime/cli/test_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "compiler/compile.h"
#include "runtime/cli/io.h"
#include "runtime/derive.h"
#include "runtime/environment.h"
#include "runtime/formats/golden_json.h"

namespace plsc::cli {

namespace {

TestCase Problem(std::string environment, std::string message) {
  return {std::move(environment), Verdict::kError, {}, std::move(message)};
}

bool IsThere(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(
      std::filesystem::symlink_status(path, ignored));
}

Result<Source> ReadPath(const std::string& path) {
  // "-" is a file's name here; standard input has no golden file beside it.
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  Io io{in, out, err};
  return ReadSource(path == "-" ? "./-" : path, io);
}

std::string Explain(const std::vector<Diagnostic>& diagnostics,
                    const Source& source) {
  return Render(diagnostics, source);
}

std::string Unreadable(const Result<Source>& source) {
  const Diagnostic& problem = source.diagnostics()[0];
  return fmt::format("error[{}]: {}\n", problem.code, problem.message);
}

std::string NamesOf(const Program& program) {
  std::string names;
  for (const NamedEnvironment& named : program.environments)
    names += " " + named.name;
  return names.empty() ? " none" : names;
}

// The environment of a golden file: a name of the genotype's file, or states
// with values.
struct Chosen {
  std::optional<NamedEnvironment> environment;
  std::string problem;
};

Chosen Choose(const Program& program, const std::string& text) {
  for (const NamedEnvironment& named : program.environments)
    if (named.name == text) return {named, ""};
  const std::vector<State>& states = program.genotype.states;
  if (states.empty() && text == "any") return {NamedEnvironment{text, {}}, ""};
  if (text.find('=') == std::string::npos)
    return {std::nullopt,
            fmt::format("error: the genotype's file names no environment '{}' "
                        "(it names:{})\n  = help: write states with values, "
                        "or remove it from the golden file\n",
                        text, NamesOf(program))};
  const Source source("environment", text);
  const Result<Environment> environment = ParseEnvironment(source, states);
  if (!environment)
    return {std::nullopt, Explain(environment.diagnostics(), source)};
  return {NamedEnvironment{text, *environment}, ""};
}

std::string TooLong(const Genotype& genotype) {
  return fmt::format(
      "error[P4001]: development would produce more than {} symbols\n"
      "  = help: lower 'iterations' (now {}), or let rules replace themselves "
      "by fewer modules\n",
      kMaxStringLength, genotype.development.iterations);
}

// Tests `golden` and, with `update`, brings it up to date.
TestCase TestOne(const Program& program, double tolerance, bool update,
                 GoldenCase& golden) {
  const Chosen chosen = Choose(program, golden.environment);
  if (!chosen.environment) return Problem(golden.environment, chosen.problem);
  std::optional<Observation> found =
      Observe(program.genotype, *chosen.environment);
  if (!found) return Problem(golden.environment, TooLong(program.genotype));
  TestCase test;
  test.environment = golden.environment;
  if (!golden.expected) {
    test.verdict = Verdict::kUnrecorded;
    test.message = "the golden file does not have this environment yet\n";
  } else {
    test.differences = Compare(*golden.expected, *found, tolerance);
    if (!test.differences.empty()) test.verdict = Verdict::kDiffers;
  }
  if (update && test.verdict != Verdict::kSame) {
    test.verdict = Verdict::kUpdated;
    test.message.clear();
    golden.expected = std::move(found);
  }
  return test;
}

// Environments that the genotype's file names and the golden file does not.
void AddNamed(const Program& program, Golden& golden) {
  for (const NamedEnvironment& named : program.environments) {
    const bool is_there = std::any_of(
        golden.cases.begin(), golden.cases.end(),
        [&](const GoldenCase& c) { return c.environment == named.name; });
    if (!is_there) golden.cases.push_back({named.name, std::nullopt});
  }
}

std::string NoEnvironment(const TestPaths& paths) {
  return fmt::format(
      "error: which environments? the genotype senses more than can be tried "
      "out, and its file names none\n"
      "  = help: write {} with the ones to test, and run plsc test --update:\n"
      "    {{\"plsc_golden\": {}, \"environments\": [{{\"environment\": "
      "\"STATE=VALUE,...\"}}]}}\n",
      paths.golden, kGoldenVersion);
}

std::optional<Program> Load(const TestPaths& paths, std::string& problem) {
  const Result<Source> source = ReadPath(paths.genotype);
  if (!source) {
    problem = Unreadable(source);
    return std::nullopt;
  }
  const Result<Program> program = Compile(*source);
  if (program) return *program;
  problem = Explain(program.diagnostics(), *source);
  return std::nullopt;
}

std::optional<Golden> LoadGolden(const TestPaths& paths, std::string& problem) {
  const Result<Source> source = ReadPath(paths.golden);
  if (!source) {
    problem = Unreadable(source);
    return std::nullopt;
  }
  Result<Golden> golden = ParseGolden(*source);
  if (golden) return *golden;
  problem = Explain(golden.diagnostics(), *source);
  return std::nullopt;
}

TestOutcome OneProblem(const TestPaths& paths, Verdict verdict,
                       std::string message) {
  TestOutcome outcome;
  outcome.tested.paths = paths;
  outcome.tested.cases.push_back({"", verdict, {}, std::move(message)});
  return outcome;
}

TestOutcome TestAll(const TestPaths& paths, const Program& program,
                    Golden golden, bool update) {
  TestOutcome outcome;
  outcome.tested.paths = paths;
  std::vector<TestCase>& cases = outcome.tested.cases;
  for (GoldenCase& golden_case : golden.cases)
    cases.push_back(
        TestOne(program, golden.descriptor_tolerance, update, golden_case));
  const auto has = [&](Verdict verdict) {
    return std::any_of(cases.begin(), cases.end(),
                       [&](const TestCase& c) { return c.verdict == verdict; });
  };
  if (update && has(Verdict::kUpdated)) {
    if (!has(Verdict::kError)) {
      outcome.new_golden = PrintGolden(golden);
      return outcome;
    }
    for (TestCase& test : cases)
      if (test.verdict == Verdict::kUpdated)
        test = Problem(test.environment,
                       "error: not updated, because another environment of "
                       "the file cannot be\n");
  }
  return outcome;
}

}  // namespace

TestOutcome TestFile(const TestPaths& paths, bool update) {
  std::string problem;
  const bool has_golden = IsThere(paths.golden);
  if (has_golden && !IsThere(paths.genotype))
    return OneProblem(
        paths, Verdict::kError,
        fmt::format("error: there is no genotype '{}' for the golden file\n",
                    paths.genotype));
  const auto program = Load(paths, problem);
  if (!program) return OneProblem(paths, Verdict::kError, problem);
  if (!has_golden && !update)
    return OneProblem(
        paths, Verdict::kUnrecorded,
        fmt::format("there is no golden file '{}'\n", paths.golden));
  Golden golden;
  if (has_golden) {
    auto loaded = LoadGolden(paths, problem);
    if (!loaded) return OneProblem(paths, Verdict::kError, problem);
    golden = std::move(*loaded);
    AddNamed(*program, golden);
  } else {
    for (std::string& name : DefaultEnvironments(*program))
      golden.cases.push_back({std::move(name), std::nullopt});
    if (golden.cases.empty())
      return OneProblem(paths, Verdict::kError, NoEnvironment(paths));
  }
  return TestAll(paths, *program, std::move(golden), update);
}

}  // namespace plsc::cli
