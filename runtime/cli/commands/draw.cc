#include <fmt/format.h>

#include <map>
#include <ostream>
#include <set>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/pictures.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/files/png.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/compare/brain_difference.h"
#include "runtime/pictures/body_text.h"
#include "runtime/pictures/brain_text.h"
#include "runtime/pictures/drawn_robot.h"
#include "runtime/pictures/side_by_side.h"

namespace plsc::cli {

namespace {

constexpr std::string_view kStandardOutput = "-";

std::optional<DrawnRobot> GrowAll(const RobotFound& robot, Io& io) {
  const Genotype& genotype = robot.loaded.mapped.program.genotype;
  DrawnRobot grown;
  for (const NamedEnvironment& named : robot.environments) {
    const auto history = DevelopWithHistory(genotype, named.environment);
    if (!history) {
      ReportGrowth(robot.loaded, named, io);
      return std::nullopt;
    }
    grown.Add(named, *history, genotype.states);
  }
  return grown;
}

std::string Picture(const DrawCommand& command, const RobotFound& robot,
                    const DrawnRobot& grown) {
  if (command.brain) return BrainsSvg(robot.title, grown.brains);
  if (command.colour == ColourBy::kRule)
    return BodiesByRuleSvg(robot.title, grown.bodies,
                           RuleTexts(robot.loaded.source, robot.loaded.mapped));
  return BodiesSvg(robot.title, grown.bodies);
}

// Which rule made which modules, a line a rule.
std::string MakersText(const DrawnBody& drawn,
                       const std::vector<std::string>& rule_texts) {
  std::map<RuleIndex, std::string> made;
  for (std::size_t i = 0; i < drawn.rules.size(); ++i)
    made[drawn.rules[i]] += " " + ModuleId(drawn.body, static_cast<int>(i));
  std::string text;
  for (const auto& [rule, modules] : made)
    text += fmt::format(
        "{}:{}\n", rule == kNoRule ? "the axiom" : rule_texts[rule], modules);
  return text;
}

// What differs from the first environment, and what its signs mean.
struct Signs {
  std::set<ModuleMark> marks;
  bool has_missing = false;
  const char* other;    // what kOther has
  const char* missing;  // the sign
};

std::string SignText(const Signs& signs, const std::string& first) {
  std::vector<std::string> parts;
  if (signs.marks.contains(ModuleMark::kNew))
    parts.push_back("━ not there in " + first);
  if (signs.marks.contains(ModuleMark::kOther))
    parts.push_back(fmt::format("═ {} than in {}", signs.other, first));
  if (signs.has_missing)
    parts.push_back(fmt::format("{} there in {} only", signs.missing, first));
  if (parts.empty()) return "";
  return fmt::format("\n{}\n", fmt::join(parts, ", "));
}

std::string DifferenceText(const std::vector<DrawnBody>& bodies) {
  Signs signs{{}, false, "another module", "╌ t"};
  for (const DrawnBody& drawn : bodies) {
    const BodyDifference difference =
        CompareBodies(bodies.front().body, drawn.body);
    signs.marks.insert(difference.marks.begin(), difference.marks.end());
    signs.has_missing |= !difference.missing.empty();
  }
  return SignText(signs, Escaped(bodies.front().name));
}

std::string DifferenceText(const std::vector<DrawnBrain>& brains) {
  Signs signs{{}, false, "other numbers", "╌"};
  for (const DrawnBrain& drawn : brains) {
    const BrainDifference difference =
        CompareBrains(brains.front().phenotype, drawn.phenotype);
    signs.marks.insert(difference.nodes.begin(), difference.nodes.end());
    signs.marks.insert(difference.edges.begin(), difference.edges.end());
    signs.has_missing |= difference.has_missing();
  }
  return SignText(signs, Escaped(brains.front().name));
}

std::string TerminalText(const DrawCommand& command, const RobotFound& robot,
                         const DrawnRobot& grown, std::size_t columns) {
  const std::vector<std::string> rule_texts =
      RuleTexts(robot.loaded.source, robot.loaded.mapped);
  CellExtent rows;  // of all, so that cores lie on a line
  for (const DrawnBody& drawn : grown.bodies) rows.Include(drawn.body);
  std::vector<std::string> blocks;
  for (std::size_t i = 0; i < grown.bodies.size(); ++i) {
    const DrawnBody& drawn = grown.bodies[i];
    std::string text = Escaped(drawn.name) + '\n';
    if (!drawn.senses.empty()) text += drawn.senses + '\n';
    if (command.brain)
      text += i == 0 ? BrainText(grown.brains[i].phenotype)
                     : BrainText(grown.brains[i].phenotype,
                                 grown.brains.front().phenotype);
    else
      text += BodyText(drawn.body, grown.bodies.front().body, rows);
    if (command.colour == ColourBy::kRule && !command.brain)
      text += MakersText(drawn, rule_texts);
    blocks.push_back(std::move(text));
  }
  return robot.title + "\n\n" + SideBySide(blocks, columns) +
         (command.brain ? DifferenceText(grown.brains)
                        : DifferenceText(grown.bodies));
}

Output OutputOf(const DrawCommand& command) {
  return {
      command.output,
      command.output.ends_with(".png") ? OutputKind::kPng : OutputKind::kSvg,
      command.force,
      {SplitGenotypePath(command.file).file}};
}

Exit WritePicture(const DrawCommand& command, const std::string& svg, Io& io) {
  std::string bytes = svg;
  if (command.output.ends_with(".png")) {
    Expected<std::string, Failure> png = PngOf(svg, command.scale);
    if (!png) return Complain(png.error(), io);
    bytes = MarkedPng(*png);
  }
  if (!WriteOutput(OutputOf(command), bytes, io)) return Exit::kBadInput;
  if (command.output == kStandardOutput) return Exit::kFine;
  io.err << fmt::format("wrote {}\n", Escaped(command.output));
  return Exit::kFine;
}

}  // namespace

Exit Run(const DrawCommand& command, Io& io) {
  if (command.output == kStandardOutput && command.terminal) {
    io.err << "plsc: --terminal and -o - would both print\n"
              "see 'plsc draw --help'\n";
    return Exit::kBadUsage;
  }
  if (!CanWrite(OutputOf(command), io)) return Exit::kBadInput;
  const auto found = FindRobot({command.file, command.individual,
                                command.environments, command.allow_range},
                               io);
  if (!found) return found.error();
  const auto& robot = *found;
  const auto grown = GrowAll(robot, io);
  if (!grown) return Exit::kBadInput;
  if (command.terminal || command.output.empty())
    io.out << TerminalText(command, robot, *grown, io.out_columns);
  if (command.output.empty()) return Exit::kFine;
  return WritePicture(command, Picture(command, robot, *grown), io);
}

}  // namespace plsc::cli
