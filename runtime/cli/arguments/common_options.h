#pragma once

// Options that mean the same of every command that has them.

#include <optional>
#include <string>

#include "runtime/cli/arguments/options.h"
#include "runtime/cli/arguments/output_format.h"
#include "sim/options.h"

namespace plsc::cli {

/// --force, of every command that writes files.
void AddForce(Options& options, bool& force);

/// -o, and --force.
Option AddOutput(Options& options, std::string& output, bool& force);

/// --format text|json; `json` says what a line of it is.
void AddFormat(Options& options, OutputFormat& format, const char* json);

void AddColor(Options& options, ColorChoice& color);

/// --jobs; `help` says of what, and that 0 is one a core.
void AddJobs(Options& options, std::optional<int>& jobs, const char* help);

/// ROBOT, of a command that takes the store of a run, too.
void AddRobot(Options& options, std::string& individual);

/// --engine, of every command that simulates; `help` says what else is to be
/// known of it there.
Option AddEngine(Options& options, std::optional<EngineKind>& engine,
                 const char* help = "");

void AddAllowRange(Options& options, bool& allow_range);

}  // namespace plsc::cli
