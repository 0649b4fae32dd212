#include "runtime/service/refusal.h"

#include <algorithm>

#include "runtime/text/diagnostic_json.h"

namespace plsc::service {

namespace {

/// Warnings may stand before what is wrong.
const Diagnostic& FirstError(const std::vector<Diagnostic>& diagnostics) {
  const auto found = std::find_if(
      diagnostics.begin(), diagnostics.end(),
      [](const Diagnostic& one) { return one.severity == Severity::kError; });
  return found == diagnostics.end() ? diagnostics.front() : *found;
}

}  // namespace

Refusal::Refusal(const std::vector<Diagnostic>& diagnostics,
                 const Source& source)
    : std::runtime_error(HeadlineOf(FirstError(diagnostics))),
      diagnostics_(DiagnosticsJson(diagnostics, source)) {}

}  // namespace plsc::service
