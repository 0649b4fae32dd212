#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "grammar/suggest.h"
#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/arguments/man_page.h"
#include "runtime/cli/arguments/shell.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/text/version.h"

namespace plsc::cli {

namespace {

Exit WriteAll(const CommandDescription& root, const std::string& folder,
              bool force, Io& io) {
  if (!MakeFolder(folder, io)) return Exit::kBadInput;
  const auto output_of = [&](const CommandDescription& command) {
    const std::filesystem::path path = folder;
    return Output{(path / (PageName(command) + ".1")).string(),
                  OutputKind::kManual, force};
  };
  for (const CommandDescription* command : AllCommands(root))
    if (!CanWrite(output_of(*command), io)) return Exit::kBadInput;
  for (const CommandDescription* command : AllCommands(root)) {
    if (!WriteOutput(output_of(*command), ManPage(*command, kVersion), io))
      return Exit::kBadInput;
  }
  return Exit::kFine;
}

}  // namespace

Exit Run(const ManCommand& command, Io& io) {
  const CommandDescription root = DescribeCommandLine();
  if (!command.all.empty())
    return WriteAll(root, command.all, command.force, io);
  const std::string name = fmt::format("{}", fmt::join(command.command, " "));
  std::vector<std::string_view> names;
  for (const CommandDescription* one : AllCommands(root)) {
    if (one->name == name) {
      io.out << ManPage(*one, kVersion);
      return Exit::kFine;
    }
    if (!one->name.empty()) names.push_back(one->name);
  }
  const auto near = Suggest(name, names);
  io.err << fmt::format("plsc: unknown command '{}'{}\n", name,
                        near ? "; did you mean '" + *near + "'?" : "");
  return Exit::kBadUsage;
}

}  // namespace plsc::cli
