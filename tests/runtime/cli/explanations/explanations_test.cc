#include "runtime/cli/explanations/explanations.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "compiler/compile.h"
#include "grammar/codes.h"
#include "runtime/advice/expectations.h"
#include "runtime/advice/lint.h"
#include "runtime/advice/trim.h"
#include "runtime/authors/genotype.h"
#include "runtime/evolve/experiment.h"
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

// Codes in what a command told.
Codes CodesIn(const std::string& told) {
  Codes codes;
  for (const std::string kind : {"error[", "warning["})
    for (std::size_t at = told.find(kind); at != std::string::npos;
         at = told.find(kind, at + 1))
      codes.insert(told.substr(at + kind.size(), 5));
  return codes;
}

// Codes of "plsc WORDS", from its text.
Codes CodesOfCommand(const std::string& line) {
  REQUIRE(line.starts_with("plsc "));
  std::istringstream words(line.substr(5));
  const std::vector<std::string> arguments(
      std::istream_iterator<std::string>(words), {});
  const Files files;
  const test::Ran ran = test::RunPlsc(arguments);
  CHECK((ran.err.find("error[") == std::string::npos) == (ran.exit == 0));
  return CodesIn(ran.err);
}

Codes CodesOfExample(ExampleKind kind, std::string_view example) {
  if (kind == ExampleKind::kCommand)
    return CodesOfCommand(std::string(example));
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
    return CodesIn(
        test::RunPlsc({"develop", "-"}, std::string(source.text())).err);
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

// Codes that the sources of `folder` write, but for the tables of codes.
Codes CodesInSources(const std::string& folder) {
  static const std::regex code("\"([PW][0-9]{4})\"");
  Codes codes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           test::InRepository(folder))) {
    const std::string name = entry.path().filename();
    const bool is_source = name.ends_with(".cc") || name.ends_with(".h");
    if (!is_source || name == "codes.cc" || name.starts_with("explain_"))
      continue;
    const std::string text = test::ReadFile(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), code), end;
         found != end; ++found)
      codes.insert((*found)[1]);
  }
  return codes;
}

TEST_CASE("What can be told has a code of the table, and each can be told",
          "[explanations]") {
  Codes told;
  for (const char* folder : {"grammar", "compiler", "sim", "runtime"})
    told.merge(CodesInSources(folder));
  // Defects of plsc, which nobody can cause.
  Codes listed = {"P1199", "P5090"};
  for (const CodeInfo& info : DiagnosticCodes()) listed.emplace(info.code);
  CHECK(told == listed);
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
