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

/// The same for who goes no further without it: prints what is wrong.
std::optional<Source> ReadOrReport(const std::string& path, Io& io);

/// "error[CODE]: cannot read 'a.pls': ...": what ReadSource found wrong, of
/// which there is no line to show.
std::string RenderWithoutLine(const Diagnostic& problem);
/// Prints it.
void ReportUnreadable(const Diagnostic& problem, Io& io);

/// Prints diagnostics to io.err.
void Report(const std::vector<Diagnostic>& diagnostics, const Source& source,
            Io& io);

}  // namespace plsc::cli
