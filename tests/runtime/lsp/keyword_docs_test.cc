#include "runtime/lsp/keyword_docs.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "compiler/limits.h"
#include "grammar/keywords.h"

namespace plsc::lsp {

TEST_CASE("Every keyword has a line", "[lsp]") {
  for (const std::string_view word : ItemKeywords())
    CHECK_FALSE(KeywordDoc(word).empty());
  for (const char* word :
       {"False", "True", "and", "bool", "if", "in", "include", "int", "not",
        "or", "plsc", "real", "replaceable", "terminal", "then"}) {
    CHECK(IsKeyword(word));
    CHECK_FALSE(KeywordDoc(word).empty());
  }
  CHECK(KeywordDoc("C").empty());
  CHECK(KeywordDoc("").empty());
}

TEST_CASE("Ranges of settings are the compiler's", "[lsp]") {
  const auto says = [](const char* word, int low, int high) {
    return KeywordDoc(word).find(fmt::format("{} to {}", low, high)) !=
           std::string_view::npos;
  };
  CHECK(says("iterations", kMinIterations, kMaxIterations));
  CHECK(says("max_modules", kMinModules, kMaxModules));
  CHECK(says("max_terms", kMinLimit, kMaxLimit));
  CHECK(says("max_rules", kMinLimit, kMaxLimit));
}

}  // namespace plsc::lsp
