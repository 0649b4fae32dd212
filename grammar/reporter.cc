#include "grammar/reporter.h"

#include <utility>

namespace plsc {

Diagnostic& Reporter::Report(Code code, Span span, std::string message) {
  return Add(Diagnostic(code, span, std::move(message)));
}

Diagnostic& Reporter::Add(Diagnostic diagnostic) {
  if (!Takes(diagnostic.severity))
    return beyond_.emplace(std::move(diagnostic));
  has_errors_ = has_errors_ || diagnostic.severity == Severity::kError;
  return diagnostics_.emplace_back(std::move(diagnostic));
}

bool Reporter::Takes(Severity severity) const {
  return diagnostics_.size() < limit_ ||
         (severity == Severity::kError && !has_errors_);
}

std::vector<Diagnostic> Reporter::Take() {
  has_errors_ = false;
  return std::exchange(diagnostics_, {});
}

}  // namespace plsc
