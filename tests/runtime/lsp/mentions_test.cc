#include "runtime/lsp/mentions.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

// How often a name of a kind is mentioned.
int Count(const std::vector<Mention>& mentions, NameKind kind,
          std::string_view name) {
  return static_cast<int>(std::count_if(
      mentions.begin(), mentions.end(), [&](const Mention& mention) {
        return mention.kind == kind && mention.name == name;
      }));
}

const Mention* MentionOf(Analysis& analysis, std::string_view at) {
  return analysis.MentionAt(
      static_cast<std::uint32_t>(analysis.text().find(at)));
}

}  // namespace

TEST_CASE("Every name is mentioned once, in order", "[lsp]") {
  Analysis analysis(kTestUri, kGecko);
  const auto& mentions = analysis.mentions();
  for (std::size_t i = 1; i < mentions.size(); ++i)
    CHECK(mentions[i - 1].span.end <= mentions[i].span.begin);
  using enum NameKind;
  CHECK(Count(mentions, kState, "inclined") == 5);
  CHECK(Count(mentions, kState, "warmth") == 4);
  CHECK(Count(mentions, kValue, "wet") == 3);
  CHECK(Count(mentions, kConstant, "mild") == 3);
  CHECK(Count(mentions, kConstant, "half") == 3);
  CHECK(Count(mentions, kEnvironment, "flat") == 2);
  CHECK(Count(mentions, kSymbol, "C") == 5);
  CHECK(Count(mentions, kGenotype, "gecko") == 1);
  CHECK(Count(mentions, kTest, "start") == 1);
}

TEST_CASE("Mentions know where they are declared", "[lsp]") {
  Analysis analysis(kTestUri, kGecko);
  for (const Mention& mention : analysis.mentions()) {
    INFO(mention.name);
    if (mention.kind == NameKind::kSymbol ||
        mention.kind == NameKind::kAlphabet) {
      CHECK(mention.is_built_in);
      CHECK_FALSE(mention.is_declared());
      continue;
    }
    REQUIRE(mention.is_declared());
    CHECK(analysis.file().Text(mention.declaration) == mention.name);
  }
}

TEST_CASE("Genotypes of a file have names of their own", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
                    "genotype one\nlet x = 1\n"
                    "environment e { a = True }\n"
                    "genotype two\nlet x = 2\nenvironment e { a = False }\n");
  std::vector<Mention> x;
  std::vector<Mention> a;
  for (const Mention& mention : analysis.mentions()) {
    if (mention.name == "x") x.push_back(mention);
    if (mention.name == "a") a.push_back(mention);
  }
  REQUIRE(x.size() == 2);
  CHECK_FALSE(NameTheSame(x[0], x[1]));
  REQUIRE(a.size() == 3);
  CHECK(NameTheSame(a[0], a[2]));
}

TEST_CASE("Own alphabets and expected bodies are mentioned", "[lsp]") {
  Analysis own(kTestUri,
               "plsc 1\nalphabet mine { replaceable X(n: int); terminal y }\n"
               "axiom Z\nrule X -> { X(1) y }\n");
  const Mention* x = MentionOf(own, "X(1)");
  REQUIRE(x != nullptr);
  CHECK(own.file().Text(x->declaration) == "X");
  CHECK(x->declaration.begin == own.text().find("X(n"));
  CHECK(x->is_module);
  const Mention* z = MentionOf(own, "Z");
  REQUIRE(z != nullptr);
  CHECK_FALSE(z->is_declared());

  Analysis body(kTestUri,
                "plsc 1\nalphabet plasticoding 1\nrule C -> { C }\n"
                "test t -> body C { front B }\n");
  const Mention* face = MentionOf(body, "front");
  REQUIRE(face != nullptr);
  CHECK(face->kind == NameKind::kFace);
}

}  // namespace plsc::lsp
