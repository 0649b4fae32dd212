#pragma once

// Diagnostics as workflow commands of GitHub Actions: printed by a job, each
// becomes an annotation beside the line of the file in a pull request.

#include <string>

#include "grammar/diagnostic.h"

namespace plsc::cli {

/// `::error file=...,line=...,title=...::message`, without the end of the line.
std::string GithubAnnotation(const Diagnostic& diagnostic,
                             const Source& source);

}  // namespace plsc::cli
