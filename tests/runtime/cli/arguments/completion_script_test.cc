#include "runtime/cli/arguments/completion_script.h"

#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/shell.h"

namespace plsc {
namespace {

using Words = std::set<std::string>;
using cli::CommandDescription;
using cli::OptionDescription;

// The real bash, completing the last of `words` in a folder.
class Bash {
 public:
  Bash() {
    folder_.Write("script", cli::CompletionScript(cli::DescribeCommandLine(),
                                                  cli::Shell::kBash));
    folder_.Write("a.pls", "");
    folder_.Write("b c.pls", "");
    folder_.Write("notes.txt", "");
    test::RunShell("mkdir '" + folder_ / "robots" + "'");
  }

  Words Complete(const std::vector<std::string>& words) const {
    std::string line = "source ./script\nCOMP_WORDS=(";
    for (const std::string& word : words) line += "'" + word + "' ";
    line += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
            "\n_plsc\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    folder_.Write("ask", line);
    const auto ran =
        test::RunShell("cd '" + folder_.path().string() + "' && bash ask");
    CHECK(ran.status == 0);
    Words found;
    std::istringstream lines(ran.out);
    for (std::string one; std::getline(lines, one);)
      if (!one.empty()) found.insert(one);
    return found;
  }

 private:
  test::TemporaryFolder folder_;
};

bool Contains(const Words& words, const std::string& word) {
  return words.contains(word);
}

TEST_CASE("bash completes every command and every option",
          "[completion_script]") {
  const Bash bash;
  const CommandDescription root = cli::DescribeCommandLine();
  for (const CommandDescription* command : cli::AllCommands(root)) {
    CAPTURE(command->name);
    std::vector<std::string> words{"plsc"};
    std::istringstream names(command->name);
    for (std::string name; names >> name;) words.push_back(name);
    words.emplace_back("");
    if (!command->commands.empty()) {
      const Words found = bash.Complete(words);
      for (const CommandDescription& below : command->commands)
        CHECK(Contains(found, cli::LastWord(below.name)));
    }
    words.back() = "-";
    const Words found = bash.Complete(words);
    std::size_t options = 0;
    for (const OptionDescription& option : command->options)
      for (const std::string& name : option.names) {
        CHECK(Contains(found, name));
        ++options;
      }
    CHECK(found.size() == options);
  }
}

TEST_CASE("bash completes words, files and folders", "[completion_script]") {
  const Bash bash;
  CHECK(bash.Complete({"plsc", "check", "--format", ""}) ==
        Words{"text", "json", "sarif", "github"});
  CHECK(bash.Complete({"plsc", "check", "--format", "=", "s"}) ==
        Words{"sarif"});
  CHECK(bash.Complete({"plsc", "check", "--format", "="}) ==
        Words{"text", "json", "sarif", "github"});
  CHECK(bash.Complete({"plsc", "random", "--encoding", "b"}) ==
        Words{"baseline"});
  CHECK(bash.Complete({"plsc", "completion", "z"}) == Words{"zsh"});
  CHECK(bash.Complete({"plsc", "study", "s"}) == Words{"status"});
  CHECK(bash.Complete({"plsc", "fmt", ""}) ==
        Words{"a.pls", "b c.pls", "robots"});
  CHECK(bash.Complete({"plsc", "trim", "a.pls", "-o", "no"}) ==
        Words{"notes.txt"});
  CHECK(bash.Complete({"plsc", "simulate", "--trajectory", ""}) ==
        Words{"robots"});
  CHECK(bash.Complete({"plsc", "random", "--seed", ""}).empty());
  CHECK(Contains(bash.Complete({"plsc", "man", "tr"}), "trim"));
}

TEST_CASE("zsh and fish are told every command and option",
          "[completion_script]") {
  const CommandDescription root = cli::DescribeCommandLine();
  const std::string zsh = cli::CompletionScript(root, cli::Shell::kZsh);
  const std::string fish = cli::CompletionScript(root, cli::Shell::kFish);
  for (const CommandDescription* command : cli::AllCommands(root)) {
    CAPTURE(command->name);
    const std::string last = cli::LastWord(command->name);
    if (!last.empty()) {
      CHECK(zsh.find("'" + last + ":") != std::string::npos);
      CHECK(fish.find(" -a " + last + " ") != std::string::npos);
    }
    for (const OptionDescription& option : command->options) {
      CAPTURE(option.names.back());
      CHECK(zsh.find(option.names.back() + "[") != std::string::npos);
      const std::string& name = option.names.back();
      CHECK(fish.find((name.starts_with("--") ? " -l " + name.substr(2)
                                              : " -s " + name.substr(1)) +
                      " ") != std::string::npos);
    }
  }
}

TEST_CASE("fish completes commands and options", "[completion_script]") {
  if (!test::HasProgram("fish")) return;
  const test::TemporaryFolder folder;
  const std::string script = folder.Write(
      "plsc.fish",
      cli::CompletionScript(cli::DescribeCommandLine(), cli::Shell::kFish));
  const auto ask = [&](const std::string& line) {
    return test::RunShell("HOME='" + folder.path().string() +
                          "' fish -c \"source " + script + "; complete -C '" +
                          line + "'\"")
        .out;
  };
  CHECK(ask("plsc tri").starts_with("trim\t"));
  CHECK(ask("plsc study sta").starts_with("status\t"));
  CHECK(ask("plsc check --format sar").starts_with("sarif"));
  CHECK(ask("plsc trim --wri").starts_with("--write\t"));
}

}  // namespace
}  // namespace plsc
