#include "runtime/cli/arguments/editors.h"

#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, LspCommand& command) {
  options.Command("lsp",
                  "Serve editors: diagnostics, hovers, completion, ... (LSP)");
  options.Flag("--stdio", command.stdio,
               "talk over standard input and output: always so; some clients "
               "say it");
  options
      .Add("--clientProcessId", command.client_process_id,
           "some clients say it; not used, the end of standard input "
           "ends the server")
      .ValueName("N");
  options.Footer(
      "Not for the terminal: an editor starts it and speaks the Language "
      "Server Protocol\n3.17 with it. How to tell VS Code, Neovim, Emacs, "
      "Helix, Kate and Sublime Text to do\nso is in docs/editors/README.md. "
      "In Neovim:\n\n"
      "  vim.lsp.start_client({ name = 'plsc', cmd = { 'plsc', 'lsp' } })\n\n"
      "Exit status 0 after 'shutdown' and 'exit', 1 when the client ends or "
      "breaks off in\nanother way.");
}

}  // namespace plsc::cli
