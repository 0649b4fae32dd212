#include "runtime/cli/explanations/explanations.h"

#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

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

bool IsNameChar(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool IsEnumerator(std::string_view name) {
  return name.starts_with('k');
}

bool IsNumber(std::string_view name) {
  return name.size() == 5 && (name[0] == 'P' || name[0] == 'W') &&
         name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

// Adds the names in `text` that stand between the two others.
void FindNames(std::string_view text, std::string_view before,
               std::string_view after, bool (*is_wanted)(std::string_view),
               std::set<std::string>& found) {
  for (std::size_t at = text.find(before); at != text.npos;
       at = text.find(before, at + 1)) {
    if (at > 0 && IsNameChar(before[0]) && IsNameChar(text[at - 1])) continue;
    const std::size_t begin = at + before.size();
    std::size_t end = begin;
    while (end < text.size() && IsNameChar(text[end])) ++end;
    const std::string_view name = text.substr(begin, end - begin);
    if (is_wanted(name) && text.substr(end).starts_with(after))
      found.emplace(name);
  }
}

// What FindNames finds in the sources of the product, but for the tables of
// codes.
std::set<std::string> FoundInSources(std::string_view before,
                                     std::string_view after,
                                     bool (*is_wanted)(std::string_view)) {
  std::set<std::string> found;
  for (const char* folder : {"grammar", "compiler", "sim", "runtime"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             test::InRepository(folder))) {
      const std::string name = entry.path().filename();
      const bool is_source = name.ends_with(".cc") || name.ends_with(".h");
      if (!is_source || name.starts_with("codes.") ||
          entry.path().parent_path().filename() == "explanations")
        continue;
      FindNames(test::ReadFile(entry.path()), before, after, is_wanted, found);
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
  CHECK(FoundInSources("Code::", "", IsEnumerator) == names);
  std::set<std::string> of_text;
  FindNames("a(\"P1234\") \"P12\" MyCode::kA Code::kB", "\"", "\"", IsNumber,
            of_text);
  FindNames("MyCode::kA Code::kB Code::b", "Code::", "", IsEnumerator, of_text);
  CHECK(of_text == std::set<std::string>{"P1234", "kB"});
  CHECK(FoundInSources("\"", "\"", IsNumber).empty());
  CHECK(FoundInSources("error[", "]:", IsNumber).empty());
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
