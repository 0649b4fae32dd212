// Options and help of the commands that shells and `man` want of plsc.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

CLI::App* AddCompletion(CLI::App& app, CompletionCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "completion", "Print a shell's script that completes plsc commands");
  sub->add_option("SHELL", command.shell, "bash, zsh or fish")
      ->required()
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Shell>{{"bash", Shell::kBash},
                                       {"zsh", Shell::kZsh},
                                       {"fish", Shell::kFish}}))
      ->type_name("bash|zsh|fish")
      ->option_text("bash|zsh|fish");
  sub->footer(
      "Completes commands, options, their words and files (.pls where a "
      "genotype is\nwanted).\n\n"
      "  source <(plsc completion bash)      in ~/.bashrc\n"
      "  plsc completion zsh > ~/.zfunc/_plsc      a folder of $fpath\n"
      "  plsc completion fish > ~/.config/fish/completions/plsc.fish");
  return sub;
}

CLI::App* AddMan(CLI::App& app, ManCommand& command) {
  CLI::App* sub =
      app.add_subcommand("man", "Print the manual page of plsc or a command");
  CLI::Option* name =
      sub->add_option("COMMAND", command.command,
                      "a command, such as check or study run (default: plsc "
                      "itself)")
          ->expected(0, 2);
  sub->add_option("--all", command.all,
                  "write all pages there, as plsc.1, plsc-check.1 and so on")
      ->option_text("FOLDER")
      ->excludes(name);
  AddForce(sub, command.force);
  sub->footer(
      "  plsc man check | man -l -\n"
      "  plsc man --all ~/.local/share/man/man1");
  return sub;
}

}  // namespace plsc::cli
