#include "grammar/builder.h"

#include <catch2/catch.hpp>

namespace plsc::grammar {
namespace {

TEST_CASE("A new item starts with empty lists behind those before it",
          "[builder]") {
  Builder b;
  b.file.text = "rule B";
  b.file.symbols.resize(3);
  b.rule.symbols.count = 3;
  b.rule.terms.count = 1;
  b.BeginItem({0, 4});
  CHECK(b.rule.symbols.first == 3);
  CHECK(b.rule.symbols.count == 0);
  CHECK(b.rule.terms.count == 0);
  b.previous_end = 6;
  b.EndItem(ast::ItemKind::kRule, 7);
  REQUIRE(b.file.items.size() == 1);
  CHECK(b.file.items[0].span == Span{0, 6});
  CHECK(b.file.items[0].index == 7);
}

TEST_CASE("A failure leaves the item with one diagnostic", "[builder]") {
  Builder b;
  b.file.text = "nonsense";
  CHECK_THROWS_AS(b.Fail(SyntaxError::kItem, 0), SyntaxFailure);
  CHECK(b.reporter.diagnostics().size() == 1);
  CHECK(b.file.is_incomplete);
}

TEST_CASE("A number too small for a double says so", "[builder]") {
  Builder b;
  b.file.text = "1e-400 0.0e-400 1e400";
  b.TakeNumber({0, 6});
  REQUIRE(b.reporter.diagnostics().size() == 1);
  CHECK(b.reporter.diagnostics()[0].label == "smallest magnitude is 5e-324");
  b.TakeNumber({7, 15});
  CHECK(b.reporter.diagnostics().size() == 1);
  CHECK(b.value.number == 0);
  b.TakeNumber({16, 21});
  REQUIRE(b.reporter.diagnostics().size() == 2);
  CHECK(b.reporter.diagnostics()[1].label ==
        "largest magnitude is 1.7976931348623157e308");
}

}  // namespace
}  // namespace plsc::grammar
