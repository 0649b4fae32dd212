#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "compiler/apply_fixes.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/texts.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/text/unified_diff.h"

namespace plsc::cli {

namespace {

// Of a removed or inserted text: line ends are part of some.
constexpr std::size_t kMaxShown = 60;

std::string Quoted(const std::string& text) {
  std::string shown = text;
  for (std::size_t at = 0; (at = shown.find('\n', at)) != std::string::npos;)
    shown.replace(at, 1, "\\n");
  return "'" + Printable(shown, kMaxShown) + "'";
}

std::string Describe(const MadeFix& fix) {
  const std::string note = fix.note.empty() ? "" : " (" + fix.note + ")";
  if (fix.removed.empty()) return "inserted " + Quoted(fix.replacement) + note;
  if (fix.replacement.empty()) return "removed " + Quoted(fix.removed) + note;
  return Quoted(fix.removed) + " -> " + Quoted(fix.replacement) + note;
}

// Whether files stay as they are.
bool IsDryRun(const FixCommand& command) {
  return command.check || command.diff;
}

// Where the mended text goes. Whether it went there.
bool Deliver(const std::string& file, const MendedText& mended,
             const FixCommand& command, Io& io) {
  if (IsDryRun(command)) return true;
  if (file == "-") {
    io.out << mended.text;
    return true;
  }
  return mended.made.empty() || WriteOrReport(file, mended.text, io);
}

// Whether the file is (now) without errors.
bool FixOne(const std::string& file, const FixCommand& command, Io& io) {
  const auto source = ReadOrReport(file, io);
  if (!source) return false;
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const MendedText mended = MendText(*source, options);
  if (!Deliver(file, mended, command, io)) return false;
  if (command.diff)
    io.out << UnifiedDiff(source->text(), mended.text, source->name(),
                          source->name() + " (mended)");
  for (const MadeFix& fix : mended.made)
    io.err << fmt::format("{}:{}:{}: {} [{}]: {}\n", Escaped(source->name()),
                          fix.position.line, fix.position.column,
                          IsDryRun(command) ? "would fix" : "fixed",
                          NumberOf(fix.code), Describe(fix));
  // The places are then of a text that nobody has on disk.
  const bool is_elsewhere = IsDryRun(command) && !mended.made.empty();
  const std::string shown_name =
      is_elsewhere ? source->name() + " (mended)" : source->name();
  Report(mended.remaining, Source(shown_name, mended.text), io);
  return !HasErrors(mended.remaining) && !is_elsewhere;
}

}  // namespace

Exit Run(const FixCommand& command, Io& io) {
  bool all_fine = true;
  for (const std::string& file : command.files)
    all_fine = FixOne(file, command, io) && all_fine;
  return all_fine ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
