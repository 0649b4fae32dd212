#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "grammar/suggest.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/man_page.h"
#include "runtime/cli/output_path.h"
#include "runtime/cli/version.h"

namespace plsc::cli {

namespace {

Exit WriteAll(const CommandDescription& root, const std::string& folder,
              Io& io) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    io.err << fmt::format("error: cannot make the folder '{}': {}\n", folder,
                          error.message());
    return Exit::kBadInput;
  }
  for (const CommandDescription* command : AllCommands(root)) {
    const std::string path =
        (std::filesystem::path(folder) / (PageName(*command) + ".1")).string();
    if (!CanWrite(path, {}, io)) return Exit::kBadInput;
    const auto failure = WriteFile(path, ManPage(*command, kVersion));
    if (!failure) continue;
    io.err << fmt::format("error: cannot write '{}': {}\n", path, *failure);
    return Exit::kBadInput;
  }
  return Exit::kFine;
}

}  // namespace

Exit Run(const ManCommand& command, Io& io) {
  const CommandDescription root = DescribeCommandLine();
  if (!command.all.empty()) return WriteAll(root, command.all, io);
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
