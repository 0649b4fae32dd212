#pragma once

// Where a stage puts what it finds wrong, up to a limit: the stage reports and
// goes on, and asks at most whether looking further is of use.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grammar/diagnostic.h"

namespace plsc {

class Reporter {
 public:
  explicit Reporter(std::size_t limit = kMaxReported) : limit_(limit) {}

  /// The one that was added, to say more of it (Diagnostic::With...) at once:
  /// the next report ends its life. Beyond the limit it goes nowhere.
  Diagnostic& Report(Code code, Span span, std::string message);
  Diagnostic& Add(Diagnostic diagnostic);

  /// Whether there is room for one more. Who describes at length, or loops over
  /// what a file may have millions of, asks before.
  bool Takes(Severity severity) const;
  /// Whether there is room for nothing at all. Warnings alone never fill it:
  /// without the first error a broken text would pass.
  bool is_full() const { return !Takes(Severity::kError); }
  bool has_errors() const { return has_errors_; }

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  /// All of them; the reporter is empty then.
  std::vector<Diagnostic> Take();

 private:
  std::size_t limit_;
  bool has_errors_ = false;
  std::vector<Diagnostic> diagnostics_;
  std::optional<Diagnostic> beyond_;  // the last that found no room
};

}  // namespace plsc
