#include "compiler/changes/written_rules.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Equal rules have equal shapes, however they are laid out",
          "[written_rules]") {
  const Source source("file",
                      "plsc 1\nalphabet plasticoding 1\n"
                      "rule B -> { add_left T(0.5) }\n"
                      "rule B -> {\n  add_left # here\n  T(0.50)\n}\n"
                      "rule B -> { add_left T(0.25) }\n");
  const WrittenFile file = ReadItems(source);
  WrittenRules rules;
  for (const WrittenItem& item : file.items)
    if (item.kind == ast::ItemKind::kRule) rules.push_back(&item);
  ContentNumbers numbers;
  const auto shapes = ShapesOf(rules, numbers);
  REQUIRE(shapes.size() == 3);
  CHECK(shapes[0] == shapes[1]);
  CHECK(shapes[0] != shapes[2]);
  CHECK(shapes[0].names == shapes[2].names);
  CHECK(numbers.Of("x") == numbers.Of("x"));
  CHECK(numbers.Of("x") != numbers.Of("y"));
}

}  // namespace
}  // namespace plsc
