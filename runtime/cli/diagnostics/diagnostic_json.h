#pragma once

// Diagnostics for scripts: one JSON object a line.

#include <string>

#include "grammar/diagnostic.h"

namespace plsc::cli {

/// Keys: severity, code, message, label, file, line, column (from 1, in
/// Unicode characters), byte_begin, byte_end, others, notes, help, fixes.
/// Without the end of the line.
std::string DiagnosticJson(const Diagnostic& diagnostic, const Source& source);

}  // namespace plsc::cli
