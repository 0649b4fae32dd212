#pragma once

// What an optimiser in another program and `plsc evaluate` say to each other:
// one JSON object a line, both ways (docs/optimisers.md).

#include <string>
#include <vector>

#include "grammar/diagnostic.h"
#include "grammar/result.h"
#include "runtime/life/season_result.h"

namespace plsc::cli {

struct EvaluationRequest {
  /// What the asker calls it, as JSON: a text or a whole number; "null" if it
  /// did not say.
  std::string id = "null";
  std::string genotype;  ///< its text
};

/// {"id": ..., "genotype": "..."}. Errors have their place in the line.
Result<EvaluationRequest> ParseEvaluationRequest(const Source& line);

/// The id of a line that is wrong otherwise, if that can be read.
std::string IdOfRequest(const std::string& line);

/// {"id", "fitness": {season: m/s or null}, "seasons": [as SeasonJson]}.
std::string EvaluationAnswer(const std::string& id, const Genotype& genotype,
                             const Evaluation& evaluation);

/// {"id", "line", "error", "diagnostics": [as DiagnosticJson]}.
std::string FailureAnswer(const std::string& id, std::size_t line,
                          const std::vector<Diagnostic>& diagnostics,
                          const Source& source);
/// Where there is no text to point at.
std::string FailureAnswer(const std::string& id, std::size_t line,
                          const std::string& failure);

}  // namespace plsc::cli
