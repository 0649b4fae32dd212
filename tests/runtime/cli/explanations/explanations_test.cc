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
    codes.emplace(NumberOf(diagnostic.code));
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
    return failure ? Codes{std::string(NumberOf(failure->code))} : Codes{};
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
    explained.emplace_back(NumberOf(row.code));
  std::vector<std::string> codes;
  for (const CodeInfo& info : DiagnosticCodes())
    codes.emplace_back(info.number);
  CHECK(explained == codes);
  CHECK(cli::FindExplanation(Code::kUnknownSymbol)->code ==
        Code::kUnknownSymbol);
  CHECK(cli::FindExplanation(Code::kParserDefect) == nullptr);
}

// What `pattern` finds in the sources of the product, but for the tables of
// codes.
std::set<std::string> FoundInSources(const char* pattern) {
  const std::regex wanted(pattern);
  std::set<std::string> found;
  for (const char* folder : {"grammar", "compiler", "sim", "runtime"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             test::InRepository(folder))) {
      const std::string name = entry.path().filename();
      const bool is_source = name.ends_with(".cc") || name.ends_with(".h");
      if (!is_source || name.starts_with("codes.") ||
          entry.path().parent_path().filename() == "explanations")
        continue;
      const std::string text = test::ReadFile(entry.path());
      for (std::sregex_iterator at(text.begin(), text.end(), wanted), end;
           at != end; ++at)
        found.insert((*at)[1]);
    }
  return found;
}

TEST_CASE("Each code can be told, by its name only", "[explanations]") {
  std::set<std::string> names;
  const std::string header =
      test::ReadFile(test::InRepository("grammar/codes.h"));
  const std::regex name("  (k\\w+),");
  for (std::sregex_iterator at(header.begin(), header.end(), name), end;
       at != end; ++at)
    names.insert((*at)[1]);
  CHECK(names.size() == DiagnosticCodes().size() + 2);  // defects of plsc
  CHECK(FoundInSources("\\bCode::(k\\w+)") == names);
  CHECK(FoundInSources("\"([PW][0-9]{4})\"").empty());
  CHECK(FoundInSources("error\\[([PW][0-9]{4})\\]:").empty());
}

TEST_CASE("Wrong examples give their code, mended ones give none",
          "[explanations]") {
  for (const Explanation& row : cli::Explanations()) {
    const std::string code(NumberOf(row.code));
    DYNAMIC_SECTION(code) {
      CHECK(CodesOfExample(row.kind, row.wrong) == Codes{code});
      CHECK(CodesOfExample(row.kind, row.mended) == Codes{});
    }
  }
}

TEST_CASE("Explanations fit a terminal and end their lines", "[explanations]") {
  for (const Explanation& row : cli::Explanations()) {
    CAPTURE(NumberOf(row.code));
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
