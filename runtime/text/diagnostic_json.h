#pragma once

// Diagnostics for scripts and pages: one JSON object each.

#include <string>
#include <vector>

#include "grammar/diagnostic.h"

namespace plsc {

/// Keys: severity, code, message, label, file, line, column (from 1, in
/// Unicode characters), byte_begin, byte_end, others, notes, help, fixes.
/// Without the end of the line.
std::string DiagnosticJson(const Diagnostic& diagnostic, const Source& source);

/// All of them, with a comma between.
std::string DiagnosticsJson(const std::vector<Diagnostic>& diagnostics,
                            const Source& source);

/// "P2003: expected ...": what an answer says first.
std::string HeadlineOf(const Diagnostic& diagnostic);

}  // namespace plsc
