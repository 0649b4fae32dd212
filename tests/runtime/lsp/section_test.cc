#include "runtime/lsp/section.h"

#include <catch2/catch.hpp>

#include "grammar/parse.h"

namespace plsc::lsp {

TEST_CASE("Each genotype of a file is a section", "[lsp]") {
  const Source source("f",
                      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
                      "genotype one\nrule C -> { C B }\n"
                      "genotype two\nrule B -> if a = True then { B }\n");
  const ParseResult parsed = Parse(source);
  const auto sections = SectionsOf(parsed.file);
  REQUIRE(sections.size() == 2);
  CHECK(sections[0].begin == source.text().find("genotype one"));
  CHECK(sections[1].begin == source.text().find("genotype two"));
  CHECK(sections[1].scope.header.states.size() == 1);
  CHECK(sections[1].resolution.heads ==
        std::vector{std::optional(plasticoding::kB)});
}

TEST_CASE("Broken and empty files have a section", "[lsp]") {
  for (const char* text : {"", "plsc 2", "plsc 1\nrule", "\x01\xFF"}) {
    const Source source("f", text);
    const ParseResult parsed = Parse(source);
    CHECK(SectionsOf(parsed.file).size() == 1);
  }
}

TEST_CASE("Genotypes that share too much are looked at as one", "[lsp]") {
  std::string text = "plsc 1\nalphabet plasticoding 1\n";
  for (int i = 0; i < 3000; ++i)
    text += "environment e" + std::to_string(i) + " { }\n";
  for (int i = 0; i < 1000; ++i)
    text += "genotype g" + std::to_string(i) + "\n";
  const Source source("f", text);
  const ParseResult parsed = Parse(source);
  CHECK(SectionsOf(parsed.file).size() == 1);
}

}  // namespace plsc::lsp
