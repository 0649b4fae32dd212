#include "runtime/cli/commands/view_editable.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/commands/view_explain.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/pages/page.h"
#include "runtime/pages/web_module.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

Exit MakeEditable(const ViewCommand& command, Io& io) {
  if (!HasPages())
    return Complain("this plsc was built without npm, and has no pages", io);
  if (command.inputs.size() != 1 || IsDatabase(command.inputs.front()))
    return Complain("--editable takes one genotype file", io);
  const auto module = FindWebModule();
  if (!module)
    return Complain(
        "this plsc was built without its module for pages (docs/web.md); "
        "`plsc live` needs none",
        io);
  const auto genotype = ReadOrReport(command.inputs.front(), io);
  if (!genotype) return Exit::kBadInput;
  nlohmann::ordered_json data;
  const std::string name =
      command.inputs.front() == "-"
          ? "robot.pls"
          : std::filesystem::path(command.inputs.front()).filename().string();
  data["robot"] = genotype->text();
  data["name"] = name;
  if (!command.scenario.empty()) {
    const auto scenario = ReadOrReport(command.scenario, io);
    if (!scenario) return Exit::kBadInput;
    data["scenario"] = scenario->text();
  }
  data["module"] = {{"packed", module->packed}, {"glue", module->glue}};
  if (!WriteOutput(PageOf(command),
                   PageHtml(PageKind::kLive, name, DumpJson(data)), io))
    return Exit::kBadInput;
  io.err << fmt::format("wrote {}\n", Escaped(command.output));
  return Exit::kFine;
}

}  // namespace plsc::cli
