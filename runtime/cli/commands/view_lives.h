#pragma once

// The inputs of `plsc view` as recorded lives: read from recordings, or lived
// now by genotypes and by robots of runs.

#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/arguments/view.h"

namespace plsc {
struct ViewedLife;
}

namespace plsc::cli {

enum class ViewInputKind : std::uint8_t { kRecording, kGenotype, kRun };

struct ViewInput {
  ViewInputKind kind = ViewInputKind::kGenotype;
  std::string path;
  std::vector<std::string> robots;  ///< of a run: ids or "best"
};

/// Told by what the file begins with, and where that tells nothing by its
/// name (*.sqlite, *.json). Numbers and "best" behind a run are robots of it.
std::vector<ViewInput> SortInputs(const std::vector<std::string>& inputs);

/// All that the command names, in that order. Everything that can be wrong is
/// looked for before anything is simulated. Prints what is wrong; nothing also
/// after Ctrl-C.
std::optional<std::vector<ViewedLife>> LoadLives(const ViewCommand& command,
                                                 Io& io);

}  // namespace plsc::cli
