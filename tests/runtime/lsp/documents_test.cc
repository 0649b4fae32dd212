#include "runtime/lsp/documents.h"

#include <catch2/catch.hpp>
#include <random>

#include "runtime/lsp/params.h"
#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

namespace {

Json Change(Place start, Place end, const std::string& text) {
  return {{"range", RangeJson({start, end})}, {"text", text}};
}

Json Opened(const std::string& text) {
  Json item = {{"uri", "u"}, {"version", 1}};
  item["text"] = text;
  return {{"textDocument", item}};
}

Json Changed(Json changes) {
  Json params = {{"textDocument", {{"uri", "u"}, {"version", 2}}}};
  params["contentChanges"] = std::move(changes);
  return params;
}

}  // namespace

TEST_CASE("Changes replace ranges of UTF-16 code units", "[lsp]") {
  const std::string gecko = "\xF0\x9F\xA6\x8E";
  CHECK(ChangedText("a\nb", Change({1, 0}, {1, 1}, "c")) == "a\nc");
  CHECK(ChangedText("a\r\nb", Change({0, 1}, {1, 0}, "")) == "ab");
  CHECK(ChangedText("#" + gecko + "x", Change({0, 3}, {0, 4}, "y")) ==
        "#" + gecko + "y");
  CHECK(ChangedText("abc", Change({0, 9}, {5, 9}, "d")) == "abcd");
  CHECK(ChangedText("abc", Change({0, 2}, {0, 1}, "-")) == "a-c");
  // The half of an emoji cannot be replaced: nothing breaks its bytes.
  CHECK(ChangedText(gecko, Change({0, 1}, {0, 1}, "x")) == "x" + gecko);
  CHECK(ChangedText("abc", {{"text", "new"}}) == "new");
}

TEST_CASE("Documents are opened, changed and closed", "[lsp]") {
  Documents documents;
  documents.Open(Opened("plsc 1\n"));
  const Document& changed = documents.Change(Changed(
      Json::array({Change({1, 0}, {1, 0}, "b"), Change({1, 0}, {1, 0}, "a")})));
  CHECK(changed.analysis->text() == "plsc 1\nab");
  CHECK(changed.version == 2);
  CHECK_FALSE(changed.is_published);
  CHECK(documents.Close({{"textDocument", {{"uri", "u"}}}}) == "u");
  CHECK(documents.all().empty());
}

TEST_CASE("A change that cannot be read changes nothing", "[lsp]") {
  Documents documents;
  documents.Open(Opened("a"));
  for (const Json& bad :
       {Json("x"), Json::array({Change({0, 0}, {0, 0}, "b"), Json(1)}),
        Json::array({{{"text", 5}}}), Json::array({{{"range", 1}}}),
        Json::array({{{"range", nullptr}, {"text", "x"}}})}) {
    INFO(bad.dump());
    CHECK_THROWS_AS(documents.Change(Changed(bad)), Fault);
    CHECK(documents.Find("u")->analysis->text() == "a");
  }
  CHECK_THROWS_WITH(documents.At({{"textDocument", {{"uri", "v"}}}}),
                    "no document 'v' is open");
}

TEST_CASE("Incremental changes come to the same text as whole ones", "[lsp]") {
  // A plain model: characters as code points, lines ended by \n.
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  const std::vector<std::string> pieces = {"a", "\n", "\xC3\xA9",
                                           "\xF0\x9F\xA6\x8E", "rule "};
  std::vector<std::string> model;  // one character each
  std::string text;
  for (int round = 0; round < 500; ++round) {
    const auto pick = [&](std::size_t size) {
      return std::uniform_int_distribution<std::size_t>(0, size)(random);
    };
    std::size_t begin = pick(model.size());
    std::size_t end = pick(model.size());
    if (begin > end) std::swap(begin, end);
    if (end - begin > 3) end = begin + 3;
    const auto place = [&](std::size_t at) {
      Place p;
      for (std::size_t i = 0; i < at; ++i) {
        if (model[i] == "\n")
          p = {p.line + 1, 0};
        else
          p.character += model[i].size() == 4 ? 2 : 1;
      }
      return p;
    };
    const std::string& piece = pieces[pick(pieces.size() - 1)];
    text = ChangedText(text, Change(place(begin), place(end), piece));
    model.erase(model.begin() + static_cast<std::ptrdiff_t>(begin),
                model.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<std::string> added;
    if (piece == "rule ")
      added = {"r", "u", "l", "e", " "};
    else
      added = {piece};
    model.insert(model.begin() + static_cast<std::ptrdiff_t>(begin),
                 added.begin(), added.end());
    std::string joined;
    for (const std::string& character : model) joined += character;
    REQUIRE(text == joined);
  }
}

}  // namespace plsc::lsp
