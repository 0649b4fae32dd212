#include "runtime/cli/explanations.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "compiler/compile.h"
#include "grammar/codes.h"
#include "runtime/evolve/experiment.h"
#include "runtime/formats/authors_genotype.h"
#include "runtime/inline_test.h"
#include "runtime/lint.h"
#include "runtime/trim.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using cli::ExampleKind;
using cli::Explanation;
using Codes = std::set<std::string>;

Codes CodesOf(const std::vector<Diagnostic>& diagnostics) {
  Codes codes;
  for (const Diagnostic& diagnostic : diagnostics)
    codes.insert(diagnostic.code);
  return codes;
}

// The files that examples of commands speak of, made in a folder of their own.
class Files {
 public:
  Files() : before_(std::filesystem::current_path()) {
    const std::string head = "plsc 1\nalphabet plasticoding 1\n";
    std::string crowded = head;
    for (int i = 0; i <= 1000; ++i)
      crowded += "sense s" + std::to_string(i) + ": bool\n";
    folder_.Write("robot.pls", head);
    folder_.Write("crowded.pls", crowded);
    folder_.Write("empty.pls", "\n");
    folder_.Write("latin1.pls", head + "# caf\xE9\n");
    folder_.Write("large.pls", head + std::string((16u << 20) + 1u, ' '));
    folder_.Write("picture.png", std::string("\x89PNG\r\n\x1A\n\0\0", 10));
    std::filesystem::current_path(folder_.path());
  }
  ~Files() { std::filesystem::current_path(before_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

 private:
  test::TemporaryFolder folder_;
  std::filesystem::path before_;
};

// Codes of "plsc check FILE", from its text.
Codes CodesOfCommand(std::string_view line) {
  REQUIRE(line.starts_with("plsc check "));
  std::string file(line.substr(11));
  file.erase(file.find('\n'));
  const Files files;
  const test::Ran ran = test::RunPlsc({"check", file});
  const std::size_t open = ran.err.find("error[");
  CHECK((open == std::string::npos) == (ran.exit == 0));
  if (open == std::string::npos) return {};
  return {ran.err.substr(open + 6, 5)};
}

Codes CodesOfExample(ExampleKind kind, std::string_view example) {
  if (kind == ExampleKind::kCommand) return CodesOfCommand(example);
  const Source source("example", std::string(example));
  if (kind == ExampleKind::kTrim) return CodesOf(Trim(source).diagnostics());
  if (kind == ExampleKind::kImport)
    return CodesOf(ImportAuthorsGenotype(source, GuessAuthorsFormat(example))
                       .diagnostics());
  if (kind == ExampleKind::kExperiment)
    return CodesOf(ParseExperiment(source).diagnostics());
  if (kind == ExampleKind::kLint) {
    const Result<MappedProgram> compiled = CompileWithMap(source);
    REQUIRE(compiled);
    return CodesOf(Lint({&*compiled, 1}, source));
  }
  if (kind == ExampleKind::kTest) {
    const Result<MappedProgram> compiled = CompileWithMap(source);
    REQUIRE(compiled);
    const auto failure = RunInlineTest(*compiled, 0);
    return failure ? Codes{failure->code} : Codes{};
  }
  const Result<Program> program = Compile(source);
  if (kind == ExampleKind::kDevelop) {
    REQUIRE(program);
    const auto ran =
        test::RunPlsc({"develop", "-"}, std::string(source.text()));
    const std::size_t open = ran.err.find("error[");
    if (open == std::string::npos) return {};
    return {ran.err.substr(open + 6, 5)};
  }
  return CodesOf(program.diagnostics());
}

TEST_CASE("Every code is explained, and nothing else", "[explanations]") {
  std::vector<std::string> explained;
  for (const Explanation& row : cli::Explanations())
    explained.emplace_back(row.code);
  std::vector<std::string> codes;
  for (const CodeInfo& info : DiagnosticCodes()) codes.emplace_back(info.code);
  CHECK(explained == codes);
  CHECK(cli::FindExplanation("P2001")->code == "P2001");
  CHECK(cli::FindExplanation("P9999") == nullptr);
}

TEST_CASE("Wrong examples give their code, mended ones give none",
          "[explanations]") {
  for (const Explanation& row : cli::Explanations()) {
    DYNAMIC_SECTION(row.code) {
      const std::string code(row.code);
      CHECK(CodesOfExample(row.kind, row.wrong) == Codes{code});
      CHECK(CodesOfExample(row.kind, row.mended) == Codes{});
    }
  }
}

TEST_CASE("Explanations fit a terminal and end their lines", "[explanations]") {
  for (const Explanation& row : cli::Explanations()) {
    CAPTURE(row.code);
    for (std::string_view text : {row.text, row.wrong, row.mended}) {
      CHECK(text.ends_with('\n'));
      while (!text.empty()) {
        CHECK(text.find('\n') <= 76);
        text.remove_prefix(text.find('\n') + 1);
      }
    }
  }
}

}  // namespace
}  // namespace plsc
