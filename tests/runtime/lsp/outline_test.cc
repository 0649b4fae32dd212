#include "runtime/lsp/outline.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

std::string Names(const Json& symbols) {
  std::string names;
  for (const Json& symbol : symbols) {
    names += symbol["name"].get<std::string>();
    if (symbol.contains("children"))
      names += "(" + Names(symbol["children"]) + ")";
    names += ' ';
  }
  return names;
}

}  // namespace

TEST_CASE("A genotype's items are its outline", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const Json outline = Outline(analysis, true);
  CHECK(Names(outline) ==
        "gecko plasticoding inclined warmth ground mild half C C B flat tilted "
        "start ");
  CHECK(outline[7]["detail"] == "inclined = False");
  CHECK(outline[5]["detail"] == "12.5");
}

TEST_CASE("Several genotypes hold what is theirs", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\n"
                    "genotype one\nrule C -> { C }\n"
                    "genotype two\niterations 2\nrule B -> { B }\n");
  const Json outline = Outline(analysis, true);
  CHECK(Names(outline) == "plasticoding one(C ) two(iterations B ) ");
  // The clients want a parent to cover its children.
  CHECK(outline[2]["range"]["end"]["line"] == 6);
  const Json flat = Outline(analysis, false);
  CHECK(Names(flat) == "plasticoding one C two iterations B ");
  CHECK(flat[5]["containerName"] == "two");
  CHECK(flat[5]["location"]["uri"] == kTestUri);
}

TEST_CASE("Clauses of several lines are shown on one", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
                    "rule C -> if a =\n   True\tthen { C }\n");
  CHECK(Outline(analysis, true)[2]["detail"] == "a = True");
}

TEST_CASE("What can be read of a broken text has an outline", "[lsp]") {
  Analysis analysis(kTestUri, "plsc 1\nsense a: bool\nrule C -> {\n");
  CHECK(Names(Outline(analysis, true)) == "a ");
}

}  // namespace plsc::lsp
