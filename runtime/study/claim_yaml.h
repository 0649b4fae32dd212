#pragma once

// Claims as a study's file has them: a map from what is claimed, in words, to
// its keys. Strict, as all of a study is.

#include <cstdint>
#include <vector>

#include "grammar/diagnostic.h"
#include "runtime/study/claim.h"

namespace plsc {

class YamlValue;
struct StudyExperiment;

/// How much of the claims can be checked.
enum class ClaimCheck : std::uint8_t {
  kWords,  ///< experiments and seasons are names of anything
  kNames,  ///< the study has them, where its file has the scenario
};

/// The claims about these experiments; what is wrong is reported at its place.
std::vector<Claim> ReadClaims(const YamlValue& value,
                              const std::vector<StudyExperiment>& experiments,
                              ClaimCheck check);

/// Claims about seasons or generations that an experiment lacks, when its
/// scenario is read from a file of its own. Without places in a text.
std::vector<Diagnostic> CheckClaims(
    const std::vector<Claim>& claims,
    const std::vector<StudyExperiment>& experiments);

}  // namespace plsc
