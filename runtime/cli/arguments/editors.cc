// Options and help of the commands that editors start.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

CLI::App* AddLsp(CLI::App& app, LspCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "lsp", "Serve editors: diagnostics, hovers, completion, ... (LSP)");
  sub->add_flag("--stdio", command.stdio,
                "talk over standard input and output: always so; some clients "
                "say it");
  sub->add_option("--clientProcessId", command.client_process_id,
                  "some clients say it; not used, the end of standard input "
                  "ends the server")
      ->option_text("N");
  sub->footer(
      "Not for the terminal: an editor starts it and speaks the Language "
      "Server Protocol\n3.17 with it. How to tell VS Code, Neovim, Emacs, "
      "Helix, Kate and Sublime Text to do\nso is in docs/editors/README.md. "
      "In Neovim:\n\n"
      "  vim.lsp.start_client({ name = 'plsc', cmd = { 'plsc', 'lsp' } })\n\n"
      "Exit status 0 after 'shutdown' and 'exit', 1 when the client ends or "
      "breaks off in\nanother way.");
  return sub;
}

}  // namespace plsc::cli
