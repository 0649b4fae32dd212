#pragma once

// The outside world as the commands see it: streams, the exit status, files by
// name. Tests put string streams in its place.

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "grammar/result.h"
#include "grammar/source.h"

namespace plsc::cli {

/// Exit status of every command.
enum class Exit : int {
  kFine = 0,
  kBadInput = 1,  ///< a file or a value is wrong; nothing was written
  kBadUsage = 2,  ///< the command line is wrong
  /// Of diff and merge, which have three answers, as diff(1): what is compared
  /// differs, or is in conflict; and what could not be compared at all.
  kDiffers = 1,
  kTrouble = 2,
  /// Ctrl-C or SIGTERM; what was done is kept. 128 + SIGINT, as shells have it.
  kInterrupted = 130,
};

struct Io {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;  ///< progress lines may be redrawn
  bool err_in_color = false;     ///< diagnostics may be painted
  bool out_in_color = false;     ///< results, likewise
  /// Characters a line of `out`; that of most terminals where nobody knows.
  std::size_t out_columns = 80;
  /// Of `in`, to wait for it and for others; -1: it never lets anybody wait.
  int input_descriptor = -1;
};

/// Whether a stream gets colour that nobody asked for: a terminal does, unless
/// the variable NO_COLOR (nullptr: not set) has any text (no-color.org).
bool WantsColor(bool is_terminal, const char* no_color);

/// The whole file, or of standard input for "-". Errors name the path and the
/// system's reason; files over 16 MiB are refused (a genotype has kilobytes).
Result<Source> ReadSource(const std::string& path, Io& io);

/// Whether the path is a descriptor of this process under a name, as
/// /dev/stdout.
bool IsDescriptor(const std::string& path);

/// Replaces `path` as a whole or not at all: writes a neighbour file, flushes
/// it to the disk and renames it. A pipe or a device is written into. The
/// reason when that fails. Whether the file may be replaced is not asked: that
/// is WriteOutput (output_path.h), which all outputs take.
std::optional<std::string> WriteFile(const std::string& path,
                                     std::string_view text);

/// How WriteFile does it, for files that are written in pieces: into what is
/// there, or as a neighbour of that name, which takes the name of the file. The
/// file is the real one, behind symbolic links.
bool IsWrittenInto(const std::string& path);
std::string NeighbourOf(const std::string& real_path);
std::string RealPath(const std::string& path);

/// "error[P5014]: cannot read 'x': Permission denied" and a newline: of what
/// has no place in a text.
std::string HeadlineOf(const Diagnostic& diagnostic);

/// As ReadSource; prints why not.
std::optional<Source> LoadSource(const std::string& path, Io& io);

/// Prints diagnostics to io.err.
void Report(const std::vector<Diagnostic>& diagnostics, const Source& source,
            Io& io);

}  // namespace plsc::cli
