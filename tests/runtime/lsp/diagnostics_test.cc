#include "runtime/lsp/diagnostics.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("A diagnostic is all that a terminal would show", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\n"
                    "sense inclined: bool\nsense inclined: bool\n");
  const Json params = PublishedJson(analysis, 7, {});
  CHECK(params["uri"] == kTestUri);
  CHECK(params["version"] == 7);
  const Json& one = params["diagnostics"][0];
  CHECK(one["code"] == "P2017");
  CHECK(one["severity"] == 1);
  CHECK(one["source"] == "plsc");
  CHECK(one["range"]["start"] == Json({{"line", 3}, {"character", 6}}));
  const Json& related = one["relatedInformation"][0];
  CHECK(related["location"]["uri"] == kTestUri);
  CHECK(related["location"]["range"]["start"]["line"] == 2);
  CHECK(related["message"] == "first declared here");
}

TEST_CASE("Help and labels are part of the message", "[lsp]") {
  Diagnostic diagnostic(Code::kNotExpressed, {}, "m");
  diagnostic.label = "l";
  diagnostic.notes = {"n"};
  diagnostic.help = "h";
  const Analysis analysis(kTestUri, "x");
  const Json advice = DiagnosticToJson(diagnostic, analysis, true);
  CHECK(advice["message"] == "m\nl\nnote: n\nhelp: h");
  CHECK(advice["severity"] == 3);
  CHECK(advice["tags"] == Json::array({1}));
  CHECK(DiagnosticToJson(diagnostic, analysis, false)["severity"] == 2);
}

TEST_CASE("Ranges count in UTF-16 behind an emoji", "[lsp]") {
  // Only comments may have other characters than ASCII.
  Analysis analysis(kTestUri,
                    "plsc 1\r\nalphabet plasticoding 1\r\n"
                    "# \xF0\x9F\xA6\x8E\r\nrule Q -> { B }\r\n");
  const Json one = PublishedJson(analysis, 1, {})["diagnostics"][0];
  CHECK(one["range"]["start"] == Json({{"line", 3}, {"character", 5}}));
}

TEST_CASE("Only so many diagnostics are sent", "[lsp]") {
  std::string text = "plsc 1\nalphabet plasticoding 1\n";
  for (int i = 0; i < 2000; ++i) text += "rule Q -> { B }\n";
  Analysis analysis(kTestUri, text);
  CHECK(PublishedJson(analysis, 1, {})["diagnostics"].size() == kMaxPublished);
}

}  // namespace plsc::lsp
