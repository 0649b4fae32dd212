#include "runtime/cli/testing/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "compiler/compile.h"
#include "compiler/environment_text.h"
#include "grammar/shown_line.h"
#include "runtime/advice/expectations.h"
#include "runtime/cli/files/io.h"
#include "runtime/compare/golden_json.h"
#include "runtime/develop/derive.h"

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
  return RenderWithoutLine(
             {Code::kTooLongString,
              {},
              fmt::format("development would produce more than {} "
                          "symbols",
                          kMaxStringLength)}) +
         fmt::format(
             "  = help: lower 'iterations' (now {}), or let rules replace "
             "themselves by fewer modules\n",
             genotype.development.iterations);
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

using Programs = std::vector<MappedProgram>;

// As golden files name the genotypes of files with several.
std::string NameInFile(const Programs& programs, const Program& program) {
  return programs.size() == 1 ? "" : program.genotype.name;
}

// The genotype that a golden file means; null when there is none.
const Program* Find(const Programs& programs, const std::string& name) {
  for (const MappedProgram& mapped : programs)
    if (NameInFile(programs, mapped.program) == name) return &mapped.program;
  return nullptr;
}

std::string UnknownGenotype(const Programs& programs, const std::string& name) {
  if (programs.size() == 1)
    return fmt::format(
        "error: the genotype's file does not hold several, so 'genotype' "
        "cannot be '{}'\n  = help: remove it from the golden file\n",
        name);
  if (name.empty())
    return "error: the genotype's file holds several\n  = help: say which in "
           "the golden file: \"genotype\": \"NAME\"\n";
  return fmt::format("error: the genotype's file has no genotype '{}'\n", name);
}

// Environments that the genotype's file names and the golden file does not.
void AddNamed(const Programs& programs, Golden& golden) {
  for (const MappedProgram& mapped : programs)
    for (const NamedEnvironment& named : mapped.program.environments) {
      const std::string genotype = NameInFile(programs, mapped.program);
      const bool is_there = std::any_of(
          golden.cases.begin(), golden.cases.end(), [&](const GoldenCase& c) {
            return c.genotype == genotype && c.environment == named.name;
          });
      if (!is_there)
        golden.cases.push_back({named.name, std::nullopt, genotype});
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

struct Loaded {
  Source source;
  Programs programs;
};

std::optional<Loaded> Load(const TestPaths& paths, std::string& problem) {
  Result<Source> source = ReadPath(paths.genotype);
  if (!source) {
    problem = RenderWithoutLine(source.diagnostics()[0]);
    return std::nullopt;
  }
  Result<Programs> programs = CompileAllWithMap(*source);
  if (programs) return Loaded{std::move(*source), std::move(*programs)};
  problem = Explain(programs.diagnostics(), *source);
  return std::nullopt;
}

std::optional<Golden> LoadGolden(const TestPaths& paths, std::string& problem) {
  const Result<Source> source = ReadPath(paths.golden);
  if (!source) {
    problem = RenderWithoutLine(source.diagnostics()[0]);
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

// The `test` items of the file itself.
void TestInline(const Loaded& loaded, std::vector<TestCase>& cases) {
  for (const MappedProgram& mapped : loaded.programs)
    for (std::size_t i = 0; i < mapped.program.tests.size(); ++i) {
      const InlineTest& inline_test = mapped.program.tests[i];
      TestCase test;
      test.environment = inline_test.place;
      test.genotype = NameInFile(loaded.programs, mapped.program);
      test.test = inline_test.name;
      if (const auto failure = RunInlineTest(mapped, i)) {
        test.verdict = Verdict::kDiffers;
        test.message = Explain({*failure}, loaded.source);
      }
      cases.push_back(std::move(test));
    }
}

// Tests the environments of the golden file, which with `update` is changed.
void TestGolden(const Programs& programs, bool update, Golden& golden,
                std::vector<TestCase>& cases) {
  for (GoldenCase& golden_case : golden.cases) {
    const Program* program = Find(programs, golden_case.genotype);
    cases.push_back(
        program == nullptr
            ? Problem(golden_case.environment,
                      UnknownGenotype(programs, golden_case.genotype))
            : TestOne(*program, golden.descriptor_tolerance, update,
                      golden_case));
    cases.back().genotype = golden_case.genotype;
  }
}

TestOutcome TestAll(const TestPaths& paths, const Loaded& loaded,
                    std::optional<Golden> golden, bool update) {
  TestOutcome outcome;
  outcome.tested.paths = paths;
  std::vector<TestCase>& cases = outcome.tested.cases;
  TestInline(loaded, cases);
  if (!golden) return outcome;
  TestGolden(loaded.programs, update, *golden, cases);
  const auto has = [&](Verdict verdict) {
    return std::any_of(cases.begin(), cases.end(),
                       [&](const TestCase& c) { return c.verdict == verdict; });
  };
  if (update && has(Verdict::kUpdated)) {
    if (!has(Verdict::kError)) {
      outcome.new_golden = PrintGolden(*golden);
      return outcome;
    }
    for (TestCase& test : cases)
      if (test.verdict == Verdict::kUpdated) {
        test.verdict = Verdict::kError;
        test.message =
            "error: not updated, because another environment of the file "
            "cannot be\n";
      }
  }
  return outcome;
}

bool HasInlineTests(const Programs& programs) {
  return std::any_of(
      programs.begin(), programs.end(),
      [](const MappedProgram& m) { return !m.program.tests.empty(); });
}

// A golden file made from nothing. Empty when a person has to choose.
Golden NewGolden(const Programs& programs) {
  Golden golden;
  for (const MappedProgram& mapped : programs)
    for (std::string& name : DefaultEnvironments(mapped.program))
      golden.cases.push_back({std::move(name), std::nullopt,
                              NameInFile(programs, mapped.program)});
  return golden;
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
  const auto loaded = Load(paths, problem);
  if (!loaded) return OneProblem(paths, Verdict::kError, problem);
  if (!has_golden && !update) {
    // Its own tests are expectation enough.
    if (HasInlineTests(loaded->programs))
      return TestAll(paths, *loaded, std::nullopt, update);
    return OneProblem(
        paths, Verdict::kUnrecorded,
        fmt::format("there is no golden file '{}'\n", paths.golden));
  }
  std::optional<Golden> golden;
  if (has_golden) {
    golden = LoadGolden(paths, problem);
    if (!golden) return OneProblem(paths, Verdict::kError, problem);
    AddNamed(loaded->programs, *golden);
  } else {
    golden = NewGolden(loaded->programs);
    if (golden->cases.empty())
      return OneProblem(paths, Verdict::kError, NoEnvironment(paths));
  }
  return TestAll(paths, *loaded, std::move(golden), update);
}

}  // namespace plsc::cli
