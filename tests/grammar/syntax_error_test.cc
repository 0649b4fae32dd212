#include "grammar/syntax_error.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Every syntax error has a code, a message and a place",
          "[syntax_error]") {
  // Texts that make the messages look at what is around the place.
  for (const std::string_view text :
       {"rule x", "{ }", "= 5", ") (", "", "\xE2\x82\xAC", "<<", "True"}) {
    for (int i = 0; i <= static_cast<int>(SyntaxError::kEnvironmentEnd); ++i) {
      for (std::uint32_t offset = 0; offset <= text.size(); ++offset) {
        SyntaxContext context;
        context.text = text;
        context.offset = offset;
        context.previous_end = offset;
        // These two are only raised behind a number's beginning.
        const auto error = static_cast<SyntaxError>(i);
        if (offset == 0 && error == SyntaxError::kDigits) continue;
        const Diagnostic found = DescribeSyntaxError(error, context);
        CAPTURE(text, i, offset);
        CHECK(NumberOf(found.code).size() == 5);
        CHECK_FALSE(found.message.empty());
        CHECK(found.span.begin <= found.span.end);
        CHECK(found.span.end <= text.size());
      }
    }
  }
}

TEST_CASE("A name of an item that is nearly one is corrected",
          "[syntax_error]") {
  SyntaxContext context;
  context.text = "enviroment x {";
  const Diagnostic found = DescribeSyntaxError(SyntaxError::kItem, context);
  REQUIRE(found.fixes.size() == 1);
  CHECK(found.fixes[0].replacement == "environment");
}

TEST_CASE("A version that is no whole number is named as it stands",
          "[syntax_error]") {
  struct Row {
    const char* text;
    const char* message;
    std::size_t fixes;
  };
  const char* const kMissing = "expected the language version after 'plsc'";
  const char* const kNotWhole = "the language version is a whole number, found";
  const Row rows[] = {
      {"plsc 1.5\nrule", kNotWhole, 1}, {"plsc v1", kNotWhole, 1},
      {"plsc 2.5 # new", kNotWhole, 0}, {"plsc -1", kNotWhole, 0},
      {"plsc one", kMissing, 0},        {"plsc", kMissing, 0},
      {"plsc \"1\"", kMissing, 0},      {"plsc\n1.5", kMissing, 0},
  };
  for (const Row& row : rows) {
    SyntaxContext context;
    context.text = row.text;
    context.offset = 4;
    context.previous_end = 4;
    const Diagnostic found =
        DescribeSyntaxError(SyntaxError::kVersionNumber, context);
    CAPTURE(row.text, found.message);
    CHECK(found.code == Code::kMissingVersion);
    CHECK(found.message.starts_with(row.message));
    CHECK(found.fixes.size() == row.fixes);
  }
}

}  // namespace
}  // namespace plsc
