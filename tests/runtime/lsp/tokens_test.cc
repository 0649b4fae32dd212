#include "runtime/lsp/tokens.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace plsc::lsp {

namespace {

// "w:name n:1 m:.. ..." with the first letters of the kinds.
std::string Kinds(std::string_view text) {
  std::string kinds;
  for (const Token& token : Tokenize(text)) {
    if (!kinds.empty()) kinds += ' ';
    kinds += "wnom#?"[static_cast<std::size_t>(token.kind)];
    kinds += text.substr(token.span.begin, token.span.end - token.span.begin);
  }
  return kinds;
}

}  // namespace

TEST_CASE("Words are told apart without a grammar", "[lsp]") {
  struct Row {
    const char* why;
    const char* text;
    const char* kinds;
  };
  const std::vector<Row> rows = {
      {"a rule", "rule C -> if a != True then {",
       "wrule wC o-> wif wa o!= wTrue wthen m{"},
      {"a range", "real in -40..60", "wreal win n-40 m.. n60"},
      {"numbers", "1 2.5 -1e3 1e-5 3e", "n1 n2.5 n-1e3 n1e-5 n3 we"},
      {"a comment ends with its line", "# a b\r\nc", "## a b wc"},
      {"a minus alone", "- a", "?- wa"},
      {"comparisons", "<= >= < > =", "o<= o>= o< o> o="},
      {"a byte order mark", "\xEF\xBB\xBFplsc", "wplsc"},
      {"other characters", "\xC3\xA9 $", "?\xC3\xA9 ?$"},
      {"continuation bytes alone", "\x80\x80", "?\x80\x80"},
      {"nothing", " \t\r\n", ""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Kinds(row.text) == row.kinds);
    }
  }
}

}  // namespace plsc::lsp
