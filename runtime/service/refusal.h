#pragma once

// Why a request gets no answer but words. Thrown by what serves a request,
// caught by the Service; leaves runtime/service nowhere.

#include <stdexcept>
#include <string>
#include <vector>

#include "grammar/diagnostic.h"

namespace plsc::service {

class Refusal : public std::runtime_error {
 public:
  explicit Refusal(const std::string& words) : std::runtime_error(words) {}
  /// Because of what is wrong with a text of the request: at least one error.
  Refusal(const std::vector<Diagnostic>& diagnostics, const Source& source);

  /// As DiagnosticsJson has them; empty where there is no text to point at.
  const std::string& diagnostics() const { return diagnostics_; }

 private:
  std::string diagnostics_;
};

}  // namespace plsc::service
