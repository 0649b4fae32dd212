#include "runtime/cli/arguments/man_page.h"

#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/shell.h"

namespace plsc {
namespace {

using cli::CommandDescription;
using cli::OptionDescription;

// As somebody reads it, without bold and line breaks.
std::string Read(const std::string& page, const test::TemporaryFolder& folder) {
  const std::string file = folder.Write("page.1", page);
  const auto ran =
      test::RunShell("groff -ww -man -Tascii -rLL=500n -P-cbou '" + file + "'");
  CHECK(ran.status == 0);
  CHECK(ran.out.find("warning:") == std::string::npos);
  return ran.out;
}

TEST_CASE("Every command has a page with all its options", "[man_page]") {
  const test::TemporaryFolder folder;
  const CommandDescription root = cli::DescribeCommandLine();
  const bool has_groff = test::HasProgram("groff");
  const bool has_mandoc = test::HasProgram("mandoc");
  for (const CommandDescription* command : cli::AllCommands(root)) {
    CAPTURE(command->name);
    const std::string page = cli::ManPage(*command, "1.2.3");
    CHECK(page.find("plsc 1.2.3") != std::string::npos);
    if (has_mandoc) {
      const auto lint = test::RunShell("mandoc -Tlint -W error '" +
                                       folder.Write("lint.1", page) + "'");
      CHECK(lint.out == "");
    }
    if (!has_groff) continue;
    const std::string text = Read(page, folder);
    for (const OptionDescription& option : command->options)
      for (const std::string& name : option.names)
        CHECK(text.find(name) != std::string::npos);
    for (const OptionDescription& positional : command->positionals)
      CHECK(text.find(positional.value) != std::string::npos);
    for (const CommandDescription& below : command->commands)
      CHECK(text.find(cli::PageName(below) + "(1)") != std::string::npos);
  }
}

TEST_CASE("Nothing of a text is taken for roff", "[man_page]") {
  if (!test::HasProgram("groff")) return;
  const test::TemporaryFolder folder;
  CommandDescription command;
  command.name = "odd";
  command.summary = "It's `odd` \\ and -- so";
  command.footer = ".TH is no title\n'neither\n\n  plsc a-b \\n '.x' ^ ~\n";
  const std::string text = Read(cli::ManPage(command, "1"), folder);
  CHECK(text.find("It's `odd` \\ and -- so") != std::string::npos);
  CHECK(text.find(".TH is no title 'neither") != std::string::npos);
  CHECK(text.find("plsc a-b \\n '.x' ^ ~") != std::string::npos);
}

}  // namespace
}  // namespace plsc
