#include "compiler/source_map.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "compiler/programs.h"

namespace plsc {
namespace {

constexpr const char* kText =
    "plsc 1 alphabet plasticoding 1 sense hot: bool\n"
    "rule T -> { T(0.5) }\n"
    "rule C -> if hot = True or hot=False then { C # core\n"
    "  add_left A2(0.5, 1, 2, 3) }\n";

std::string Text(const Source& source, Span span) {
  return std::string(source.text().substr(span.begin, span.end - span.begin));
}

TEST_CASE("A map has the place of every part of every rule", "[source_map]") {
  const Source source("test", kText);
  const auto mapped = CompileWithMap(source);
  REQUIRE(mapped);
  // In the genotype the rules of C come before those of T.
  REQUIRE(mapped->map.rules.size() == 2);
  const RuleSpans& core = mapped->map.rules[0];
  CHECK(Text(source, core.head) == "C");
  CHECK(source.PositionOf(core.rule.begin).line == 3);
  CHECK(Text(source, core.clause) == "hot = True or hot=False");
  REQUIRE(core.terms.size() == 2);
  CHECK(Text(source, core.terms[1]) == "hot=False");
  REQUIRE(core.symbols.size() == 3);
  CHECK(Text(source, core.symbols[2]) == "A2(0.5, 1, 2, 3)");
  CHECK(Text(source, mapped->map.rules[1].rule) == "rule T -> { T(0.5) }");
  CHECK(mapped->map.rules[1].clause == Span{});
  CHECK(mapped->map.axiom == Span{});
}

TEST_CASE("A symbol is found from any of its bytes", "[source_map]") {
  const Source source("test", kText);
  const auto mapped = CompileWithMap(source);
  REQUIRE(mapped);
  struct Row {
    const char* why;
    Position position;
    std::optional<SymbolPlace> expected;
  };
  const std::vector<Row> rows = {
      {"a name's first byte", {4, 3}, SymbolPlace{0, 1}},
      {"a name's last byte", {4, 10}, SymbolPlace{0, 1}},
      {"the blank after it", {4, 11}, std::nullopt},
      {"an argument", {4, 17}, SymbolPlace{0, 2}},
      {"another rule", {2, 13}, SymbolPlace{1, 0}},
      {"a head is no symbol", {2, 6}, std::nullopt},
      {"a comment", {3, 48}, std::nullopt},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto offset = source.OffsetOf(row.position);
      REQUIRE(offset);
      CHECK(FindSymbol(mapped->map, *offset) == row.expected);
    }
  }
}

TEST_CASE("Compiling with a map gives the same program and diagnostics",
          "[source_map]") {
  for (const auto& file : testing::ValidProgramFiles()) {
    const Source source("test", testing::ReadFile(file));
    const auto plain = Compile(source);
    const auto mapped = CompileWithMap(source);
    REQUIRE(static_cast<bool>(plain) == static_cast<bool>(mapped));
    CHECK(plain.diagnostics().size() == mapped.diagnostics().size());
    if (!plain) continue;
    CHECK(*plain == mapped->program);
    // Each symbol's text begins with the name that the IR has.
    const Genotype& genotype = plain->genotype;
    REQUIRE(mapped->map.rules.size() == genotype.rules.size());
    for (std::size_t r = 0; r < genotype.rules.size(); ++r) {
      const RuleSpans& spans = mapped->map.rules[r];
      const Rule& rule = genotype.rules[r];
      CHECK(Text(source, spans.head) == (*genotype.alphabet)[rule.head].name);
      CHECK(spans.terms.size() == rule.clause.terms.size());
      REQUIRE(spans.symbols.size() == rule.production.size());
      for (std::size_t i = 0; i < spans.symbols.size(); ++i)
        CHECK(
            Text(source, spans.symbols[i])
                .starts_with((*genotype.alphabet)[rule.production[i].id].name));
    }
  }
}

TEST_CASE("A map of a wrong text is its errors", "[source_map]") {
  const Source source("test", "plsc 1 alphabet plasticoding 1 rule C -> { D }");
  const auto mapped = CompileWithMap(source);
  REQUIRE_FALSE(mapped);
  CHECK(mapped.diagnostics()[0].code == Code::kUnknownSymbol);
}

}  // namespace
}  // namespace plsc
