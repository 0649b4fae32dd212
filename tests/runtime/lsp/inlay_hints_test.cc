#include "runtime/lsp/inlay_hints.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

// "LINE:CHARACTER label" each, places from 0.
std::vector<std::string> Hints(const std::string& text,
                               const std::string& environment) {
  Analysis analysis(kTestUri, text);
  std::vector<std::string> shown;
  for (const Json& hint : InlayHints(
           analysis, {0, static_cast<std::uint32_t>(text.size())}, environment))
    shown.push_back(hint["position"]["line"].dump() + ":" +
                    hint["position"]["character"].dump() + " " +
                    hint["label"].get<std::string>());
  return shown;
}

using HintLines = std::vector<std::string>;

}  // namespace

TEST_CASE("Rules are marked in the chosen environment", "[lsp]") {
  CHECK(Hints(kGecko, "") == HintLines{"10:36 active, joined 1 of 2",
                                       "15:70 active, joined 2 of 2"});
  CHECK(Hints(kGecko, "tilted") == HintLines{"10:36 inactive", "15:70 active"});
  CHECK(Hints(kGecko, "inclined=False,warmth=0,ground=wet") ==
        HintLines{"10:36 active", "15:70 inactive"});
  CHECK(Hints(kGecko, "nowhere").empty());
}

TEST_CASE("A rule without a clause is marked where others join it", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "rule B -> { T(0.5) }\r\nrule B -> if a = True then { B } # why\n"
      "environment on { a = True }\nenvironment off { a = False }\n";
  CHECK(Hints(text, "on") ==
        HintLines{"3:20 active, joined 1 of 2", "4:38 active, joined 2 of 2"});
  CHECK(Hints(text, "off") == HintLines{"4:38 inactive"});
}

TEST_CASE("Each genotype has its own environments", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "genotype one\nrule C -> if a = True then { C }\n"
      "environment here { a = True }\n"
      "genotype two\nrule C -> if a = True then { C }\n"
      "environment there { a = False }\n";
  CHECK(Hints(text, "") == HintLines{"4:32 active", "7:32 inactive"});
  CHECK(Hints(text, "there") == HintLines{"7:32 inactive"});
}

TEST_CASE("Rules of a text that is broken elsewhere are marked", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "rule C -> if a = True then { C }\nrule C -> if b = True then { C }\n"
      "environment on { a = True }\nrule B -> {\n";
  CHECK(Hints(text, "") == HintLines{"3:32 active"});
}

TEST_CASE("Hints say where and how many", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const auto size = static_cast<std::uint32_t>(analysis.text().size());
  const Json hints = InlayHints(analysis, {0, size}, "tilted");
  CHECK(hints[1]["tooltip"] ==
        "in tilted (inclined=True,warmth=12.5,ground=wet): 1 of the rules of C "
        "is active");
  CHECK(InlayHints(analysis, {0, 20}, "tilted").empty());
}

}  // namespace plsc::lsp
