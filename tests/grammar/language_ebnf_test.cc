#include "grammar/language_ebnf.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <sstream>

#include "grammar/keywords.h"

namespace plsc::testing {
namespace {

std::string Document() {
  std::ostringstream text;
  text << std::ifstream(PLSC_SOURCE_DIR "/docs/language.md").rdbuf();
  return text.str();
}

TEST_CASE("The EBNF in docs/language.md is that of the parser", "[ebnf]") {
  const std::string document = Document();
  INFO(
      "`cmake --build --preset release --target update_ebnf` puts the "
      "parser's grammar into docs/language.md");
  CHECK(WithEbnf(document, LanguageEbnf()) == document);
}

TEST_CASE("The EBNF is of the language, not of the parser", "[ebnf]") {
  const std::string ebnf = LanguageEbnf();
  // Every item is there, and nothing that a reader of C++ only would know.
  for (const std::string_view keyword : ItemKeywords())
    CHECK(ebnf.find("\"" + std::string(keyword) + "\"") != std::string::npos);
  for (const char* const leak :
       {"::", "pegtl", "must", "skip", "recover", "lost", "token", "gap"}) {
    CAPTURE(leak);
    CHECK(ebnf.find(leak) == std::string::npos);
  }
}

TEST_CASE("Every rule that the EBNF names is there once", "[ebnf]") {
  const std::string ebnf = LanguageEbnf();
  const std::string bare =
      std::regex_replace(ebnf, std::regex(R"("[^"]*"|'[^']*'|\?[^?]*\?)"), "");
  static const std::regex kWord("[a-z_]+");
  for (std::sregex_iterator it(bare.begin(), bare.end(), kWord), end; it != end;
       ++it) {
    const std::string name = it->str();
    CAPTURE(name);
    const std::regex line("(^|\n)" + name + " *=");
    CHECK(std::distance(std::sregex_iterator(bare.begin(), bare.end(), line),
                        std::sregex_iterator()) == 1);
  }
}

TEST_CASE("The EBNF goes between the marks of a document", "[ebnf]") {
  CHECK(WithEbnf("a\n<!-- grammar: x -->\nold\n<!-- end of grammar -->\nb\n",
                 "new\n") ==
        "a\n<!-- grammar: x -->\n```ebnf\nnew\n```\n<!-- end of grammar "
        "-->\nb\n");
  CHECK(WithEbnf("a\n", "new\n").empty());
  CHECK(WithEbnf("<!-- grammar: x -->\n", "new\n").empty());
}

}  // namespace
}  // namespace plsc::testing
