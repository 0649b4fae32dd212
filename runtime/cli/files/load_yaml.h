#pragma once

// Reading scenario, experiment and study files for a command: the same errors
// whichever command asked.

#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/diagnostics/sarif.h"
#include "runtime/cli/files/io.h"
#include "runtime/evolve/experiment.h"
#include "runtime/scenario/scenario.h"
#include "runtime/study/study.h"

namespace plsc::cli {

/// An empty path is the paper's scenario. Prints what is wrong to io.err.
std::optional<Scenario> LoadScenario(const std::string& path, Io& io);

/// With the scenario of its own file, if it names one (relative to the
/// experiment's folder), and checked: every season answers every state.
std::optional<Experiment> LoadExperiment(const std::string& path, Io& io);

/// Likewise, with the scenario of every experiment; none names a file then.
std::optional<Study> LoadStudy(const std::string& path, Io& io);

/// The engine that was asked for, if any, in place of what the seasons say.
/// Prints what keeps it from living them, as in an error of the file.
bool UseEngine(std::optional<EngineKind> engine, Scenario& scenario, Io& io);

/// Says that the seasons could be lived faster, if they could.
void MentionSwift(const Scenario& scenario, Io& io);

/// What is wrong with a file, and with those that it names.
using Findings = std::vector<CheckedFile>;

/// The same of texts that are read already, for who prints what is found in
/// another way. `profile`: of a scenario that names none.
std::optional<Scenario> ReadScenarioText(const Source& source,
                                         Findings& findings,
                                         Profile profile = Profile::kPaper);
std::optional<Experiment> ReadExperimentText(const Source& source,
                                             Findings& findings, Io& io);
std::optional<Study> ReadStudyText(const Source& source, Findings& findings,
                                   Io& io);

}  // namespace plsc::cli
