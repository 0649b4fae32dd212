#include "fuzz/require.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace plsc::fuzz {

namespace {

// Rendering costs more than parsing, and the second diagnostic of a kind looks
// like the first.
constexpr std::size_t kRendered = 3;

bool IsInside(Span span, const Source& source) {
  return span.begin <= span.end && span.end <= source.text().size();
}

}  // namespace

void Require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

Source AsSource(const std::uint8_t* data, std::size_t size) {
  return {"fuzz", std::string(reinterpret_cast<const char*>(data), size)};
}

void RequireSound(const std::vector<Diagnostic>& diagnostics,
                  const Source& source) {
  for (const Diagnostic& diagnostic : diagnostics) {
    Require(diagnostic.code != Code::kParserDefect,
            "a diagnostic has a code that users may see");
    Require(diagnostic.code != Code::kFormatterDefect,
            "the formatter found its own defect");
    Require(!diagnostic.message.empty(), "a diagnostic says what is wrong");
    Require(IsInside(diagnostic.span, source),
            "a diagnostic is about a place of the text");
    for (const Label& other : diagnostic.others)
      Require(IsInside(other.span, source),
              "a second place is a place of the text");
    for (const Fix& fix : diagnostic.fixes)
      Require(IsInside(fix.span, source), "a fix is about a place of the text");
  }
  const std::size_t shown = std::min(diagnostics.size(), kRendered);
  for (std::size_t i = 0; i < shown; ++i)
    Require(Render(diagnostics[i], source).ends_with('\n'),
            "a diagnostic can be shown");
}

}  // namespace plsc::fuzz
