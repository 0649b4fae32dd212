#pragma once

// What we tell a user about a text of theirs: one structure from which every
// rendering (text, JSON) is made. No stage prints; runtime/cli does.

#include <string>
#include <vector>

#include "grammar/source.h"

namespace plsc {

enum class Severity : std::uint8_t { kError, kWarning };

/// A second place that explains the first ("opened here").
struct Label {
  Span span;
  std::string text;
};

/// Replace `span` by `replacement`; an empty span inserts.
struct Fix {
  Span span;
  std::string replacement;
};

/// Text is lower case, names what was expected before what was found.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;     ///< "P2001"; empty where none is assigned
  Span span;            ///< the primary place, under the caret
  std::string message;  ///< the headline
  std::string label;    ///< beside the caret; may be empty
  std::vector<Label> others;
  std::vector<std::string> notes;  ///< "= note: ..."
  std::string help;                ///< "= help: ..."; may be empty
  std::vector<Fix> fixes;
};

/// file:line:column, the line, a caret, the notes; ends in a newline.
/// Deterministic, without colour.
std::string Render(const Diagnostic& diagnostic, const Source& source);

/// All of them by position, at most `limit` (then a line that counts the
/// rest); 0 shows all.
std::string Render(std::vector<Diagnostic> diagnostics, const Source& source,
                   int limit = 20);

}  // namespace plsc
