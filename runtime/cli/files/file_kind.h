#pragma once

// Which kind of file of ours a text is, by what it says, not by its name: so a
// command can be given any of them.

#include <cstdint>
#include <string_view>

namespace plsc::cli {

enum class FileKind : std::uint8_t {
  kGenotype,  ///< also whatever looks like none of the others
  kExperiment,
  kScenario,
  kStudy,
  kGolden,
  kRecording,
  kDigest,  ///< of a study
  kStore,   ///< an SQLite database
};

FileKind KindOf(std::string_view text);

}  // namespace plsc::cli
