#pragma once

// What we tell a user about a text of theirs: one structure from which every
// rendering (text, JSON) is made. No stage prints; runtime/cli does.

#include <string>
#include <vector>

#include "grammar/codes.h"
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

/// Text is lower case, names what was expected before what was found. What
/// more there is to say is added where it is made:
/// `Diagnostic(Code::kLimit, span, "...").WithHelp("...")`.
struct Diagnostic {
  /// The severity is the code's.
  Diagnostic(Code code, Span span, std::string message);

  Diagnostic& WithLabel(std::string text);
  Diagnostic& WithOther(Span place, std::string text);
  Diagnostic& WithNote(std::string text);
  Diagnostic& WithHelp(std::string text);
  Diagnostic& WithFix(Span place, std::string replacement);

  Severity severity;
  Code code;
  Span span;            ///< the primary place, under the caret
  std::string message;  ///< the headline
  std::string label;    ///< beside the caret; may be empty
  std::vector<Label> others;
  std::vector<std::string> notes;  ///< "= note: ..."
  std::string help;                ///< "= help: ..."; may be empty
  std::vector<Fix> fixes;
};

bool HasErrors(const std::vector<Diagnostic>& diagnostics);

/// A stage stops reporting here (grammar/reporter.h): nobody reads more, and a
/// hostile file could hold millions. So that many or more may not be all.
inline constexpr std::size_t kMaxReported = 1000;

/// By position, in the order of reporting where that is the same, and without
/// those that say the same of the same place again.
void SortAndDropRepeated(std::vector<Diagnostic>* diagnostics);

/// How a rendering looks; the text is the same with and without colour.
struct RenderOptions {
  int limit = 20;         ///< most diagnostics that are shown; 0 shows all
  bool in_color = false;  ///< with the escape sequences of a terminal
};

/// file:line:column, the line, a caret, the notes; ends in a newline.
/// Deterministic.
std::string Render(const Diagnostic& diagnostic, const Source& source,
                   bool in_color = false);

/// A place alone, with its label: file:line:column, the line, a caret.
std::string RenderPlace(Span span, const std::string& label,
                        const Source& source);

/// All of them by position, at most `options.limit`, then a line that counts
/// the rest: what is known of it where a stage has stopped adding.
std::string Render(std::vector<Diagnostic> diagnostics, const Source& source,
                   const RenderOptions& options);

/// Without colour.
std::string Render(std::vector<Diagnostic> diagnostics, const Source& source,
                   int limit = 20);

}  // namespace plsc
