#include "runtime/cli/diagnostics/github_annotation.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

Diagnostic At(Span span) {
  return {Code::kUnknownSymbol, span, "a message"};
}

TEST_CASE("An annotation names the place and all there is to say", "[github]") {
  Diagnostic diagnostic = At({9, 13});
  diagnostic.label = "here";
  diagnostic.notes.emplace_back("a note");
  diagnostic.help = "do this";
  const Source source("robots/a.pls", "line 1\n\xC3\xA9 word\n");
  // Columns are characters: the word is the third to the sixth of its line.
  CHECK(cli::GithubAnnotation(At({10, 14}), source) ==
        "::error file=robots/a.pls,line=2,col=3,endLine=2,endColumn=7,"
        "title=P2001::a message");
  CHECK(cli::GithubAnnotation(diagnostic, Source("a", "0123456789abcdef")) ==
        "::error file=a,line=1,col=10,endLine=1,endColumn=14,title=P2001::"
        "a message%0Ahere%0Anote: a note%0Ahelp: do this");
}

TEST_CASE("Warnings are warnings; a place of several lines has no end column",
          "[github]") {
  const Diagnostic diagnostic(Code::kNotExpressed, {0, 3}, "a message");
  CHECK(cli::GithubAnnotation(diagnostic, Source("a", "x\ny\n")) ==
        "::warning file=a,line=1,col=1,endLine=2,title=W4002::a message");
}

TEST_CASE("Texts of the user's cannot end or forge a command", "[github]") {
  Diagnostic diagnostic = At({0, 1});
  diagnostic.message = "100% of\r\n::error::it\x1B[31m";
  const std::string text =
      cli::GithubAnnotation(diagnostic, Source("a,b:c%\n.pls", "x"));
  CHECK(text ==
        "::error file=a%2Cb%3Ac%25%0A.pls,line=1,col=1,endLine=1,endColumn=2,"
        "title=P2001::100%25 of??::error::it?[31m");
}

}  // namespace
}  // namespace plsc
