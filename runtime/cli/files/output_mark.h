#pragma once

// What a command writes, and how a file says that plsc wrote it: the mark by
// which one output knows an older one.

#include <cstdint>
#include <string>
#include <string_view>

namespace plsc::cli {

enum class OutputKind : std::uint8_t {
  kGenotype,
  kRobot,  ///< for another program, in any format
  kTable,  ///< of a run, CSV
  kPage,
  kSvg,
  kPng,
  kRecording,
  kTrajectory,
  kScenario,  ///< beside trajectories
  kReport,
  kClaims,        ///< of a report, as text
  kReportTable,   ///< as CSV
  kReportTables,  ///< as Markdown
  kDigest,
  kChildren,  ///< JSON lines of mutate and cross
  kRunLines,  ///< JSON lines of a run
  kTestText,
  kTestJson,
  kTestJunit,
  kManual,
};

/// "page", "picture"; of a kind that is replaced.
std::string_view KindName(OutputKind kind);

/// Whether a file of that kind is replaced by another at all. Genotypes, robots
/// and tables are not: people go on working on them.
bool IsReplaced(OutputKind kind);

/// Whether the file carries the mark of its kind, by its first kMarkBytes and
/// its last ones.
bool HasMark(OutputKind kind, std::string_view beginning, std::string_view end);
constexpr std::size_t kMarkBytes = 65536;

/// First line of a trajectory's scenario.
inline constexpr std::string_view kScenarioMark =
    "# Written by `plsc simulate --trajectory`, which replaces it.\n";

/// The picture with the mark that says so.
std::string MarkedPng(std::string_view png);

}  // namespace plsc::cli
