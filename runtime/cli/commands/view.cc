#include <fmt/format.h>

#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/view.h"
#include "runtime/cli/commands/view_editable.h"
#include "runtime/cli/commands/view_explain.h"
#include "runtime/cli/commands/view_lives.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/pages/page.h"
#include "runtime/recording/view_json.h"

namespace plsc::cli {

namespace {

// Titles are for tabs and bookmarks, which show some 30 characters.
std::string TitleOf(const std::vector<ViewedLife>& lives) {
  std::string title = lives.front().recording.name;
  if (lives.size() == 2) title += " and " + lives.back().recording.name;
  if (lives.size() > 2)
    title += fmt::format(" and {} others", lives.size() - 1);
  return title;
}

}  // namespace

Exit Run(const ViewCommand& command, Io& io) {
  if (command.explain) return Explain(command, io);
  if (command.editable) return MakeEditable(command, io);
  if (!HasPages()) {
    io.err << "error: this plsc was built without npm, and has no pages\n";
    return Exit::kBadInput;
  }
  if (!CanWrite(PageOf(command), io)) return Exit::kBadInput;
  const InterruptHandler handler;
  const auto lives = LoadLives(command, io);
  if (InterruptHandler::is_interrupted()) return Exit::kInterrupted;
  if (!lives) return Exit::kBadInput;
  const std::string page =
      PageHtml(PageKind::kView, TitleOf(*lives), ViewJson(*lives));
  if (!WriteOutput(PageOf(command), page, io)) return Exit::kBadInput;
  io.err << fmt::format("wrote {}\n", Escaped(command.output));
  return Exit::kFine;
}

}  // namespace plsc::cli
