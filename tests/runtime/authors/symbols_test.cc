#include "runtime/authors/symbols.h"

#include <catch2/catch.hpp>
#include <set>

#include "compiler/foreign_names.h"

namespace plsc {
namespace {

TEST_CASE("Every symbol has one token, the one that messages name",
          "[authors_symbols]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  std::set<std::string_view> tokens;
  for (std::size_t i = 0; i < alphabet.symbols().size(); ++i) {
    const auto id = static_cast<SymbolId>(i);
    const AuthorsSymbol& symbol = AuthorsSymbolOf(id);
    CHECK(FindAuthorsSymbol(symbol.token) == &symbol);
    CHECK(tokens.insert(symbol.token).second);
    // C and B are called alike.
    const std::string_view ours = PlasticodingNameFor(symbol.token);
    CHECK((ours.empty() ? symbol.token : ours) == alphabet[id].name);
  }
  CHECK(FindAuthorsSymbol("A1") == nullptr);
}

TEST_CASE("Parameters of joints change places, and back", "[authors_symbols]") {
  Reporter reporter;
  const AuthorsWord word{"AJ2", {0, 3}, {{0.5, {}}, {2, {}}, {3, {}}, {4, {}}}};
  const auto symbol = ImportSymbol(word, false, &reporter);
  REQUIRE(symbol);
  CHECK(symbol->id == plasticoding::kA1);
  CHECK(symbol->arguments[plasticoding::kWeight] == 0.5);
  CHECK(symbol->arguments[plasticoding::kPeriod] == 2);
  CHECK(symbol->arguments[plasticoding::kPhaseOffset] == 3);
  CHECK(symbol->arguments[plasticoding::kAmplitude] == 4);
  CHECK(AuthorsParameters(*symbol) == std::vector<double>{0.5, 2, 3, 4});
}

TEST_CASE("A number out of range is a warning where that is wanted",
          "[authors_symbols]") {
  const AuthorsWord word{"ST", {0, 4}, {{2, {3, 4}}}};
  Reporter reporter;
  CHECK_FALSE(ImportSymbol(word, false, &reporter));
  CHECK(ImportSymbol(word, true, &reporter)->arguments[0] == 2);
  const std::vector<Diagnostic>& problems = reporter.diagnostics();
  REQUIRE(problems.size() == 2);
  CHECK(problems[0].severity == Severity::kError);
  CHECK(problems[1].severity == Severity::kWarning);
  CHECK(problems[1].span == Span{3, 4});
}

}  // namespace
}  // namespace plsc
