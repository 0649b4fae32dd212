#pragma once

// Comments that silence warnings: `# plsc: allow W3002 W3003` for the item
// that the comment belongs to (the one that it stands in, behind or before, as
// for the formatter), `# plsc: allow-file W3002` for the file. Errors cannot
// be silenced.

#include <span>
#include <string>
#include <vector>

#include "grammar/ast.h"
#include "grammar/reporter.h"
#include "grammar/source.h"

namespace plsc {

class Suppressions {
 public:
  explicit Suppressions(const ast::File& file);

  /// Whether a comment silences `code` at `place`.
  bool Allows(Code code, Span place) const;
  /// Those that stay: errors, and what no comment silences.
  std::vector<Diagnostic> Keep(std::vector<Diagnostic> diagnostics) const;
  /// W1001: comments that ask for what does not exist.
  const std::vector<Diagnostic>& diagnostics() const {
    return reporter_.diagnostics();
  }

 private:
  struct Allowed {
    Code code;
    Span where;
  };

  void Read(const ast::File& file, Span comment);
  void ReadCodes(const ast::File& file, std::span<const Span> words,
                 bool is_for_file);
  void Warn(Span span, std::string message, std::string help);

  std::vector<Allowed> allowed_;
  Reporter reporter_;
};

}  // namespace plsc
