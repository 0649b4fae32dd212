#pragma once

// What the commands that read runs share: names of individuals, what is wrong.

#include <string>
#include <vector>

#include "runtime/cli/files/io.h"
#include "runtime/store/run_store.h"

namespace plsc::cli {

/// Whether the file begins as an SQLite database does, which stores of runs
/// are, whatever its name. A pipe is left unread.
bool IsDatabase(const std::string& path);

/// "error: ..." and the exit status for it.
Exit Complain(const Failure& failure, Io& io);

/// A number, or "best": the best of the last completed generation.
Expected<int, Failure> IdOf(RunStore& store, const std::string& name);
/// Likewise; the best if there are no names.
Expected<std::vector<int>, Failure> IdsOf(
    RunStore& store, const std::vector<std::string>& names);
/// Everybody who was evaluated, by id.
Expected<std::vector<int>, Failure> EvaluatedIds(RunStore& store);

/// "plsc 0.2.0, results 2, ODE 0.16.2, compiler 12.2.0"; of the articulated
/// engine "plsc 0.2.0, results 2, the same on any machine".
std::string VersionsText(const Versions& versions);

}  // namespace plsc::cli
