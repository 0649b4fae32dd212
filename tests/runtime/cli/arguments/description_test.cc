#include <algorithm>
#include <catch2/catch.hpp>

#include "runtime/cli/arguments/command_description.h"

namespace plsc {
namespace {

using cli::CommandDescription;
using cli::OptionDescription;
using cli::ValueKind;

const CommandDescription& Find(const CommandDescription& root,
                               const std::string& name) {
  for (const CommandDescription* command : cli::AllCommands(root))
    if (command->name == name) return *command;
  FAIL("no command " << name);
  return root;
}

const OptionDescription& OptionOf(const CommandDescription& command,
                                  const std::string& name) {
  for (const OptionDescription& option : command.options)
    if (std::find(option.names.begin(), option.names.end(), name) !=
        option.names.end())
      return option;
  FAIL("no option " << name);
  return command.options.front();
}

TEST_CASE("The description has commands, options and what they take",
          "[command_description]") {
  const CommandDescription root = cli::DescribeCommandLine();
  CHECK(root.name.empty());
  CHECK(Find(root, "study run").positionals.size() == 1);

  const CommandDescription& check = Find(root, "check");
  CHECK(check.summary == "Say whether files are correct");
  CHECK(check.footer.find("plsc check robots/*.pls") != std::string::npos);
  CHECK(OptionOf(check, "--lint").kind == ValueKind::kNone);
  CHECK(OptionOf(check, "--max-errors").kind == ValueKind::kOther);
  CHECK(OptionOf(check, "--format").choices ==
        std::vector<std::string>{"text", "json", "sarif", "github"});
  CHECK(check.positionals[0].kind == ValueKind::kFile);
  CHECK(check.positionals[0].is_required);
  CHECK(check.positionals[0].is_repeated);

  const CommandDescription& trim = Find(root, "trim");
  CHECK(OptionOf(trim, "-o").names ==
        std::vector<std::string>{"-o", "--output"});
  CHECK(OptionOf(trim, "-o").kind == ValueKind::kFile);
  CHECK_FALSE(trim.positionals[0].is_repeated);
  const CommandDescription& random = Find(root, "random");
  CHECK_FALSE(OptionOf(random, "--seed").is_required);
  CHECK(OptionOf(Find(root, "mutate"), "--seed").is_required);
  CHECK(OptionOf(random, "--encoding").kind == ValueKind::kChoice);
  CHECK(OptionOf(Find(root, "simulate"), "--trajectory").kind ==
        ValueKind::kFolder);
  CHECK(Find(root, "report").positionals[0].kind == ValueKind::kFile);
}

TEST_CASE("No command or option lacks its help", "[command_description]") {
  const CommandDescription root = cli::DescribeCommandLine();
  for (const CommandDescription* command : cli::AllCommands(root)) {
    CAPTURE(command->name);
    CHECK_FALSE(command->summary.empty());
    for (const OptionDescription& option : command->options)
      CHECK_FALSE(option.help.empty());
    for (const OptionDescription& positional : command->positionals) {
      CHECK_FALSE(positional.help.empty());
      CHECK_FALSE(positional.value.empty());
    }
  }
}

}  // namespace
}  // namespace plsc
