#include "grammar/diagnostic.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

Diagnostic At(Span span, std::string message) {
  return {Code::kUnknownItem, span, std::move(message)};
}

TEST_CASE("A diagnostic shows its line, a caret and all it has to say",
          "[diagnostic]") {
  const Source source("a.pls", "first line\nsecond line\n");
  Diagnostic diagnostic = At({18, 22}, "something is wrong");
  diagnostic.label = "this";
  diagnostic.others.push_back({{0, 5}, "because of this"});
  diagnostic.notes.emplace_back("a note");
  diagnostic.help = "what to do";
  CHECK(Render(diagnostic, source) ==
        "error[P1101]: something is wrong\n"
        " --> a.pls:2:8\n"
        "2 | second line\n"
        "  |        ^^^^ this\n"
        "1 | first line\n"
        "  | ----- because of this\n"
        "  = note: a note\n"
        "  = help: what to do\n");
}

TEST_CASE("Carets stand under what is meant, whatever is before it",
          "[diagnostic]") {
  struct Row {
    const char* why;
    const char* text;
    Span span;
    const char* shown;
  };
  const std::vector<Row> rows = {
      {"a tab is shown as blanks to the next multiple of 4",
       "\tx",
       {1, 2},
       "1 |     x\n  |     ^\n"},
      {"characters of several bytes take one column",
       "\xC3\xA9 x",
       {3, 4},
       "1 | \xC3\xA9 x\n  |   ^\n"},
      {"control characters cannot drive the terminal",
       "\x1B[2J x",
       {5, 6},
       "1 | ?[2J x\n  |      ^\n"},
      {"bytes that are no UTF-8 are shown as one",
       "\xFF x",
       {2, 3},
       "1 | ? x\n  |   ^\n"},
      {"an empty place gets one caret", "x", {1, 1}, "1 | x\n  |  ^\n"},
      {"a span over lines is marked to the end of the first",
       "ab\ncd",
       {1, 4},
       "1 | ab\n  |  ^\n"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string text = Render(At(row.span, "m"), Source("a", row.text));
      CHECK(text.substr(text.find("1 |")) == row.shown);
    }
  }
}

TEST_CASE("A list is sorted by position and cut at the limit", "[diagnostic]") {
  const Source source("a", "abc");
  const std::vector<Diagnostic> all = {At({2, 3}, "third"), At({0, 1}, "first"),
                                       At({1, 2}, "second")};
  const std::string two = Render(all, source, 2);
  CHECK(two.find("first") < two.find("second"));
  CHECK(two.find("third") == std::string::npos);
  CHECK(two.find("... and 1 more (--max-errors 0 shows all)\n") !=
        std::string::npos);
  const std::string everything = Render(all, source, 0);
  CHECK(everything.find("third") != std::string::npos);
  CHECK(everything.find("more") == std::string::npos);
}

TEST_CASE("A line too long for a terminal is cut around the place",
          "[diagnostic]") {
  const std::string text = std::string(5000, 'a') + "X" + std::string(99, 'b');
  const std::string shown = Render(At({5000, 5001}, "m"), Source("a", text));
  CHECK(shown.size() < 500);
  CHECK(shown.find('X') != std::string::npos);
}

TEST_CASE("A message that quotes a name of megabytes is cut", "[diagnostic]") {
  const Source source("a", "x");
  // An odd number of bytes before characters of two: cut between characters.
  std::string name = "x";
  for (int i = 0; i < 100000; ++i) name += "\xC3\xA9";
  const std::string shown = Render(At({0, 1}, name), source);
  CHECK(shown.size() < 2 * 450);  // 400 characters of two bytes, and the frame
  CHECK(shown.find("\xC3...") == std::string::npos);
  CHECK(shown.find("\xC3\xA9...") != std::string::npos);
}

TEST_CASE("Colour changes nothing but the colour", "[diagnostic]") {
  const Source source("a.pls", "first line\nsecond line\n");
  Diagnostic diagnostic = At({18, 22}, "something is wrong");
  diagnostic.label = "this";
  diagnostic.others.push_back({{0, 5}, "because of this"});
  diagnostic.notes.emplace_back("a note");
  diagnostic.help = "what to do";
  for (const Severity severity : {Severity::kError, Severity::kWarning}) {
    diagnostic.severity = severity;
    const std::string plain = Render(diagnostic, source);
    CHECK(plain.find('\033') == std::string::npos);
    std::string colored = Render(diagnostic, source, true);
    CHECK(colored.find(severity == Severity::kError
                           ? "\033[1;31merror[P1101]\033[0m"
                           : "\033[1;33mwarning[P1101]\033[0m") == 0);
    for (std::size_t at = 0; (at = colored.find('\033')) != std::string::npos;)
      colored.erase(at, colored.find('m', at) - at + 1);
    CHECK(colored == plain);
  }
}

TEST_CASE("What is not shown is counted as far as it is known",
          "[diagnostic]") {
  const Source source("a.pls", "x\n");
  const auto last_line = [&](std::size_t count, int limit) {
    const std::string text = Render(
        std::vector<Diagnostic>(count, At({0, 1}, "wrong")), source, limit);
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
  };
  CHECK(last_line(20, 20) == "  | ^\n");
  CHECK(last_line(21, 20) == "... and 1 more (--max-errors 0 shows all)\n");
  CHECK(last_line(kMaxReported - 1, 20) ==
        "... and 979 more (--max-errors 0 shows all)\n");
  // From here on nobody has counted.
  CHECK(last_line(kMaxReported, 20) ==
        "... and at least 980 more (--max-errors 0 shows 1000)\n");
  CHECK(last_line(kMaxReported, 0) ==
        "... and perhaps more: the search ends here\n");
}

TEST_CASE("A place alone is shown like that of a diagnostic", "[diagnostic]") {
  const Source source("a.pls", "first line\nsecond line\n");
  Diagnostic diagnostic = At({18, 22}, "something is wrong");
  diagnostic.label = "this";
  CHECK("error[P1101]: something is wrong\n" +
            RenderPlace({18, 22}, "this", source) ==
        Render(diagnostic, source));
}

TEST_CASE("A place on a line of megabytes is shown as on one that is long",
          "[diagnostic]") {
  const auto shown = [](std::size_t before, std::size_t after) {
    const std::string line =
        std::string(before, 'a') + "\xC3\xA9here" + std::string(after, 'b');
    const auto at = static_cast<std::uint32_t>(before) + 2;
    const std::string text =
        Render(At({at, at + 4}, "wrong"), Source("a.pls", line + "\n"));
    return text.substr(text.find("1 | "));
  };
  const std::string wanted = shown(400, 400);
  CHECK(wanted.find("...aaa") != std::string::npos);
  CHECK(shown(2'000'000, 400) == wanted);
  CHECK(shown(2'000'000, 2'000'000) == wanted);
  CHECK(shown(401, 2'000'000) == wanted);
}

}  // namespace
}  // namespace plsc
