#include "runtime/cli/commands/view_explain.h"

#include <fmt/format.h>

#include <ostream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/commands/view_lives.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/history/explained_robot.h"
#include "runtime/pages/page.h"

namespace plsc::cli {

namespace {

Expected<ExplainedRobot, Exit> ExplainOne(const RobotAsked& asked, Io& io) {
  auto found = FindRobot(asked, io);
  if (!found) return found.error();
  const RobotFound& robot = *found;
  auto explained = ExplainRobot(robot.title, robot.loaded.source,
                                robot.loaded.mapped, robot.environments);
  if (explained) return std::move(*explained);
  if (explained.error().why == NotExplained::Why::kGrown)
    ReportGrowth(robot.loaded, explained.error().environment, io);
  else
    io.err << fmt::format(
        "error: {}\n  = help: fewer environments (--env), or ask `plsc why`\n",
        TooManyToShow(robot.title));
  return Exit::kBadInput;
}

/// One robot each.
std::optional<std::vector<RobotAsked>> AskedOf(const ViewCommand& command,
                                               Io& io) {
  std::vector<RobotAsked> asked;
  for (const ViewInput& input : SortInputs(command.inputs)) {
    if (input.kind == ViewInputKind::kRecording) {
      io.err << fmt::format(
          "error: {} is a recording; --explain takes genotype files and "
          "runs\n",
          input.path);
      return std::nullopt;
    }
    std::vector<std::string> robots = input.robots;
    if (robots.empty())
      robots.push_back(input.kind == ViewInputKind::kRun ? "best" : "");
    for (const std::string& robot : robots)
      asked.push_back(
          {input.path, robot, command.environments, command.allow_range});
  }
  return asked;
}

}  // namespace

Output PageOf(const ViewCommand& command) {
  std::vector<std::string> inputs = command.inputs;
  inputs.push_back(command.scenario);
  return {command.output, OutputKind::kPage, command.force, std::move(inputs)};
}

Exit Explain(const ViewCommand& command, Io& io) {
  if (!HasPages())
    return Complain("this plsc was built without npm, and has no pages", io);
  if (!CanWrite(PageOf(command), io)) return Exit::kBadInput;
  const auto asked = AskedOf(command, io);
  if (!asked) return Exit::kBadInput;
  std::vector<ExplainedRobot> robots;
  for (const RobotAsked& one : *asked) {
    auto robot = ExplainOne(one, io);
    if (!robot) return robot.error();
    robots.push_back(std::move(*robot));
  }
  const std::string page =
      PageHtml(PageKind::kExplain, robots.front().title + " explained",
               ExplainJson(robots));
  if (!WriteOutput(PageOf(command), page, io)) return Exit::kBadInput;
  io.err << fmt::format("wrote {}\n", Escaped(command.output));
  return Exit::kFine;
}

}  // namespace plsc::cli
