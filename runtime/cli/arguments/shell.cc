#include "runtime/cli/arguments/shell.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, CompletionCommand& command) {
  options.Command("completion",
                  "Print a shell's script that completes plsc commands");
  options
      .Choice("SHELL", command.shell, "bash, zsh or fish",
              {{"bash", Shell::kBash},
               {"zsh", Shell::kZsh},
               {"fish", Shell::kFish}})
      .Required();
  options.Footer(
      "Completes commands, options, their words and files (.pls where a "
      "genotype is\nwanted).\n\n"
      "  source <(plsc completion bash)      in ~/.bashrc\n"
      "  plsc completion zsh > ~/.zfunc/_plsc      a folder of $fpath\n"
      "  plsc completion fish > ~/.config/fish/completions/plsc.fish");
}

void Add(Options& options, ManCommand& command) {
  options.Command("man", "Print the manual page of plsc or a command");
  const Option name =
      options
          .Add("COMMAND", command.command,
               "a command, such as check or study run (default: plsc "
               "itself)")
          .Count(0, 2);
  options
      .Add("--all", command.all,
           "write all pages there, as plsc.1, plsc-check.1 and so on")
      .ValueName("FOLDER")
      .Excludes(name);
  AddForce(options, command.force);
  options.Footer(
      "  plsc man check | man -l -\n"
      "  plsc man --all ~/.local/share/man/man1");
}

}  // namespace plsc::cli
