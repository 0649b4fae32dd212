#include <fmt/format.h>

#include <ostream>

#include "compiler/format.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/texts.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/text/unified_diff.h"

namespace plsc::cli {

namespace {

// Whether the file is (now) as it should be.
bool FormatOne(const std::string& file, const FmtCommand& command, Io& io) {
  const auto source = ReadOrReport(file, io);
  if (!source) return false;
  FormatOptions options;
  options.compact = command.compact;
  const Result<std::string> formatted = Format(*source, options);
  if (!formatted) {
    Report(formatted.diagnostics(), *source, io);
    io.err << fmt::format("{}: not formatted\n", Escaped(source->name()));
    return false;
  }
  const bool is_same = *formatted == source->text();
  if (command.check) {
    if (!is_same) io.out << Escaped(source->name()) << '\n';
    return is_same;
  }
  if (command.diff) {
    io.out << UnifiedDiff(source->text(), *formatted, source->name(),
                          source->name() + " (formatted)");
    return is_same;
  }
  if (command.to_stdout || file == "-") {
    io.out << *formatted;
    return true;
  }
  if (is_same) return true;
  return WriteOrReport(file, *formatted, io);
}

}  // namespace

Exit Run(const FmtCommand& command, Io& io) {
  bool all_fine = true;
  for (const std::string& file : command.files)
    all_fine = FormatOne(file, command, io) && all_fine;
  return all_fine ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
