// The documents are held to the code: their programs compile (or fail, where
// marked), and the tables of docs/language.md are those of the alphabet and of
// the codes.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/check_symbols.h"
#include "compiler/compile.h"
#include "compiler/format.h"
#include "compiler/programs.h"
#include "grammar/codes.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;

struct Block {
  std::string where;
  std::string text;
  bool is_error = false;
};

std::vector<Block> BlocksOf(const fs::path& path) {
  std::istringstream file(testing::ReadFile(path));
  std::vector<Block> blocks;
  bool is_inside = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (is_inside && line == "```") {
      is_inside = false;
    } else if (is_inside) {
      blocks.back().text += line + "\n";
    } else if (line == "```pls" || line == "```pls error") {
      is_inside = true;
      blocks.push_back({fmt::format("{}:{}", path.filename().string(), number),
                        "", line != "```pls"});
    }
  }
  return blocks;
}

std::vector<fs::path> Documents() {
  const fs::path root(PLSC_SOURCE_DIR);
  std::vector<fs::path> paths = {root / "README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  return paths;
}

std::string Documentation() {
  return testing::ReadFile(fs::path(PLSC_SOURCE_DIR) / "docs" / "language.md");
}

// What stands between `<!-- name: ...` and `<!-- end of name -->`.
std::string Between(const std::string& text, const std::string& name) {
  const std::size_t mark = text.find("<!-- " + name + ":");
  const std::size_t begin = text.find('\n', mark) + 1;
  const std::size_t end = text.find("<!-- end of " + name + " -->");
  REQUIRE(mark != std::string::npos);
  REQUIRE(end != std::string::npos);
  return text.substr(begin, end - begin);
}

TEST_CASE("Programs in the documentation are what they claim to be", "[docs]") {
  std::vector<Block> blocks;
  for (const fs::path& path : Documents())
    for (Block& block : BlocksOf(path)) blocks.push_back(std::move(block));
  REQUIRE(blocks.size() >= 12);
  for (const Block& block : blocks) {
    DYNAMIC_SECTION(block.where) {
      const Source source(block.where, block.text);
      const auto result = CompileAll(source);
      INFO(Render(result.diagnostics(), source));
      CHECK(static_cast<bool>(result) == !block.is_error);
      if (!block.is_error) CHECK(Format(source));
    }
  }
}

TEST_CASE("No program in the documentation is fenced otherwise", "[docs]") {
  for (const fs::path& path : Documents()) {
    std::istringstream file(testing::ReadFile(path));
    std::string fence;  // the line that opened the block at hand
    for (std::string line; std::getline(file, line);) {
      CAPTURE(path, line);
      const std::size_t text = line.find_first_not_of(' ');
      if (text != std::string::npos && line.substr(text).starts_with("```"))
        fence = fence.empty() ? line : "";
      else if (line.starts_with("plsc ") && line.size() > 5 && line[5] >= '0' &&
               line[5] <= '9')  // a program's first line
        CHECK((fence == "```pls" || fence == "```pls error"));
    }
    CHECK(fence.empty());
  }
}

TEST_CASE("The documented symbols are those of plasticoding 1", "[docs]") {
  static const char* const kCategories[] = {"module",
                                            "mounting",
                                            "moving",
                                            "controller-moving",
                                            "controller-changing",
                                            "terminal"};
  std::string table = "| symbol | category | replaceable |\n|---|---|---|\n";
  for (const SymbolInfo& symbol : PlasticodingAlphabet()->symbols())
    table += fmt::format("| `{}` | {} | {} |\n", Signature(symbol),
                         kCategories[static_cast<int>(symbol.category)],
                         symbol.is_replaceable ? "yes" : "no");
  CHECK(Between(Documentation(), "symbols") == table);
}

TEST_CASE("The documented codes are all there are", "[docs]") {
  std::string table = "| code | meaning |\n|---|---|\n";
  for (const CodeInfo& info : DiagnosticCodes())
    table += fmt::format("| {} | {} |\n", info.number, info.meaning);
  CHECK(Between(Documentation(), "codes") == table);
}

TEST_CASE("Every code that the test programs meet is documented", "[docs]") {
  for (const auto& path : testing::ProgramFiles()) {
    const Result<Program> result =
        Compile(Source(path.string(), testing::ReadFile(path)));
    for (const Diagnostic& diagnostic : result.diagnostics()) {
      CAPTURE(path, NumberOf(diagnostic.code));
      CHECK(FindCode(NumberOf(diagnostic.code)));
    }
  }
}

}  // namespace
}  // namespace plsc
