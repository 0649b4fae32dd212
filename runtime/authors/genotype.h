#pragma once

// Genotypes of the authors' program (Revolve): its export, one line of Python
// (docs/housekeeping.md), and the older lines of tokens that it reads. To a
// genotype of plsc and back; what is lost on the way is said in warnings.

#include <string>
#include <string_view>
#include <vector>

#include "compiler/program.h"
#include "grammar/result.h"
#include "grammar/source.h"
#include "runtime/authors/symbols.h"

namespace plsc {

enum class AuthorsFormat : std::uint8_t {
  kRepr,   ///< `{<Alphabet.CORE_COMPONENT: 'C'>: [...], ...}`
  kLines,  ///< `C C addf AJ1_0.5|2|3|4 `
};

/// By the first character that is no blank.
AuthorsFormat GuessAuthorsFormat(std::string_view text);

struct ImportOptions {
  std::string name = "imported";  ///< of the genotype; a name of plsc
  bool allow_range = false;       ///< parameters out of range: warnings
  /// Takes the second rule off the end of the first where Revolve joined them
  /// in the level season before it wrote the text (its rules share lists).
  bool unjoin = false;
};

/// States are those that clauses ask about, in the order of the text; a
/// genotype that senses one thing gets environments named after the worlds of
/// the paper, plane and tilted5. Settings are the paper's, as the formats have
/// none: with them the limits of terms and rules that Revolve's operators keep
/// to, larger ones where the text has more (one rule a symbol without clauses).
/// Errors are of the kinds that plsc has for its own texts, and P5200
/// for broken notation; W5200 tells what is lost.
Result<Program> ImportAuthorsGenotype(const Source& source,
                                      AuthorsFormat format,
                                      const ImportOptions& options = {});

/// The text that Revolve would export (its letters' order, shortest numbers
/// that read back), without a line end. P5200 where Revolve cannot say it: an
/// alphabet of the file's own, states that are not bool, rules without clauses
/// beside others of their symbol. W5200: settings other than the paper's, and
/// limits other than an import of the text would give.
Result<std::string> AuthorsGenotypeText(const Genotype& genotype);

/// A rule as it was read, before its symbols are looked at.
struct AuthorsRule {
  AuthorsWord letter;
  Clause clause;
  Span span;
  std::vector<AuthorsWord> symbols;
};

/// What both readers make of a text.
struct AuthorsText {
  std::vector<AuthorsRule> rules;  ///< in the order of the text
  std::vector<std::string> states;
  bool has_clauses = false;
  std::vector<Diagnostic> problems;  ///< an error, or warnings
};
AuthorsText ReadAuthorsRepr(const Source& source);
AuthorsText ReadAuthorsLines(const Source& source);

}  // namespace plsc
