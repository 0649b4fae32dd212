#include "runtime/lsp/semantic_tokens.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

struct Decoded {
  Place place;
  std::uint32_t length = 0;
  std::string type;
  unsigned modifiers = 0;
};

std::vector<Decoded> Decode(const Json& tokens) {
  const auto data = tokens["data"].get<std::vector<std::uint32_t>>();
  REQUIRE(data.size() % 5 == 0);
  const Json types = SemanticTokensLegend()["tokenTypes"];
  std::vector<Decoded> decoded;
  Place at;
  for (std::size_t i = 0; i < data.size(); i += 5) {
    if (data[i] > 0) at = {at.line + data[i], 0};
    at.character += data[i + 1];
    REQUIRE(data[i + 3] < types.size());
    decoded.push_back({at, data[i + 2], types[data[i + 3]], data[i + 4]});
  }
  return decoded;
}

Span WholeOf(const Analysis& analysis) {
  return {0, static_cast<std::uint32_t>(analysis.text().size())};
}

}  // namespace

TEST_CASE("Tokens are in order and do not overlap", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const auto tokens = Decode(SemanticTokens(analysis, WholeOf(analysis)));
  REQUIRE(tokens.size() > 90);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    CHECK(tokens[i].length > 0);
    if (i == 0 || tokens[i].place.line != tokens[i - 1].place.line) continue;
    CHECK(tokens[i].place.character >=
          tokens[i - 1].place.character + tokens[i - 1].length);
  }
}

TEST_CASE("Names have the colour of what they name", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\nlet x = 0.5\n"
                    "sense a: bool # \xF0\x9F\xA6\x8E\n"
                    "rule C -> if a = True then { C T(x) what }\n");
  std::string shown;
  for (const Decoded& token :
       Decode(SemanticTokens(analysis, WholeOf(analysis))))
    shown += std::to_string(token.place.line) + ":" +
             std::to_string(token.place.character) + "+" +
             std::to_string(token.length) + " " + token.type + "/" +
             std::to_string(token.modifiers) + "\n";
  CHECK(shown ==
        "0:0+4 keyword/0\n0:5+1 number/0\n"
        "1:0+8 keyword/0\n1:9+12 namespace/4\n1:22+1 number/0\n"
        "2:0+3 keyword/0\n2:4+1 variable/3\n2:6+1 operator/0\n2:8+3 number/0\n"
        "3:0+5 keyword/0\n3:6+1 variable/1\n3:9+4 keyword/0\n"
        "3:14+4 comment/0\n"
        "4:0+4 keyword/0\n4:5+1 type/4\n4:7+2 operator/0\n4:10+2 keyword/0\n"
        "4:13+1 variable/0\n4:15+1 operator/0\n4:17+4 keyword/0\n"
        "4:22+4 keyword/0\n4:29+1 type/4\n4:31+1 type/4\n4:33+1 variable/2\n"
        "4:36+4 function/0\n");
}

TEST_CASE("A range has its own tokens only", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const auto begin =
      static_cast<std::uint32_t>(analysis.text().find("let mild"));
  const auto tokens = Decode(SemanticTokens(analysis, {begin, begin + 15}));
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[0].place == Place{7, 0});
}

TEST_CASE("Broken texts have colours", "[lsp]") {
  Analysis analysis(kTestUri, "plsc 1\nrule C -> if (a = True");
  CHECK(Decode(SemanticTokens(analysis, WholeOf(analysis))).size() == 7);
}

// Not timed; with a look at the line's beginning for each token it would take
// minutes.
TEST_CASE("A document may be a single line of megabytes", "[lsp]") {
  std::string text = "plsc 1 alphabet plasticoding 1 sense hot: bool ";
  while (text.size() < 1'000'000)
    text += "rule B -> if hot = True then { B add_left T(0.5) } ";
  Analysis analysis(kTestUri, text);
  const auto tokens = Decode(SemanticTokens(analysis, WholeOf(analysis)));
  CHECK(tokens.size() > 200'000);
  CHECK(tokens.back().place.line == 0);
  CHECK(tokens.back().place.character == text.rfind("0.5"));
}

}  // namespace plsc::lsp
