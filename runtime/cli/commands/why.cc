#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "compiler/print.h"
#include "grammar/number.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/develop/environment_json.h"
#include "runtime/develop/part_names.h"
#include "runtime/history/history_text.h"
#include "runtime/history/provenance_json.h"
#include "runtime/history/provenance_text.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

// "a.pls:12:5" as "a.pls" and 12:5; without such an end all of it is the file.
struct FileAndPlace {
  std::string file;
  std::optional<Position> place;
};

// The number behind the last ':' of `text`, which is cut off.
std::optional<int> CutNumber(std::string* text) {
  const std::size_t colon = text->rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::string digits = text->substr(colon + 1);
  constexpr std::size_t kMostDigits = 9;  // fits an int; files have 16 MiB
  if (digits.empty() || digits.size() > kMostDigits ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  text->resize(colon);
  return ParseNumber<int>(digits);
}

FileAndPlace Split(const std::string& text) {
  std::string file = text;
  const std::optional<int> column = CutNumber(&file);
  const std::optional<int> line = column ? CutNumber(&file) : std::nullopt;
  if (!line || file.empty()) return {text, std::nullopt};
  // As diagnostics name it, and as arguments.cc names "-:12:5".
  if (file == "<stdin>") file = "-";
  return {file, Position{*line, *column}};
}

std::optional<PhenotypePart> PartOf(const WhyCommand& command) {
  if (!command.module.empty())
    return PhenotypePart{PartKind::kModule, command.module};
  if (!command.node.empty())
    return PhenotypePart{PartKind::kNode, command.node};
  if (!command.edge.empty())
    return PhenotypePart{PartKind::kEdge, command.edge};
  return std::nullopt;
}

std::string Heading(const Genotype& genotype, const NamedEnvironment& named) {
  const std::string senses =
      PrintEnvironment(named.environment, genotype.states);
  std::string text =
      fmt::format("{} in {}", genotype.name, Escaped(named.name));
  if (!senses.empty() && senses != named.name)
    text += fmt::format(" ({})", senses);
  return text;
}

// The answer of one environment as a line.
void PrintJson(const Genotype& genotype, const NamedEnvironment& named,
               const Json& answer, Io& io) {
  Json json;
  json["genotype"] = genotype.name;
  json["environment"] = EnvironmentJson(named.environment, genotype.states);
  json.update(answer);
  // The file's name may be any bytes; JSON must stay UTF-8.
  io.out << DumpJson(json) << '\n';
}

std::string AbsenceText(const Phenotype& phenotype, const PhenotypePart& part) {
  const std::vector<std::string> ids = IdsOf(phenotype, part.kind);
  return fmt::format(
      "no {} {}; there is {}\n", KindName(part.kind), part.id,
      ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, ", ")));
}

// Back from a part; false when the robot of this environment has none such.
bool ExplainPart(const HistoryView& view, const NamedEnvironment& named,
                 const PhenotypePart& part, OutputFormat format, Io& io) {
  const auto found = HistoryOf(*view.history.trace, part);
  if (format == OutputFormat::kJson) {
    PrintJson(view.genotype, named, PartJson(view, part, found), io);
  } else {
    io.out << Heading(view.genotype, named) << ": ";
    if (found)
      io.out << fmt::format("{} {}\n", KindName(part.kind), found->id)
             << PartText(view, *found);
    else
      io.out << AbsenceText(view.history.trace->phenotype, part);
    io.out << '\n';
  }
  return found.has_value();
}

void ExplainSymbol(const HistoryView& view, const NamedEnvironment& named,
                   SymbolPlace place, OutputFormat format, Io& io) {
  if (format == OutputFormat::kJson)
    return PrintJson(view.genotype, named, FatesJson(view, place), io);
  io.out << Heading(view.genotype, named) << ":\n" << FatesText(view, place);
}

// The symbol that the user points at. Prints what is wrong.
std::optional<SymbolPlace> FindPlace(const LoadedProgram& loaded,
                                     Position position, Io& io) {
  const auto offset = loaded.source.OffsetOf(position);
  if (!offset) {
    io.err << fmt::format("error: {} has no line {} with a column {}\n",
                          loaded.source.name(), position.line, position.column);
    return std::nullopt;
  }
  const auto place = FindSymbol(loaded.mapped.map, *offset);
  if (!place)
    io.err << "error: no symbol of a production is here\n"
           << RenderPlace({*offset, *offset}, "", loaded.source)
           << "  = help: point at a symbol between the braces of a rule\n";
  return place;
}

struct Question {
  std::optional<PhenotypePart> part;
  std::optional<SymbolPlace> place;
};

// Of a file, or of a run, whose seasons are the environments then.
Expected<LoadedProgram, Exit> Load(const WhyCommand& command,
                                   const FileAndPlace& from, Io& io) {
  if (!IsRobotNamed(from.file, command.individual, io)) return Exit::kBadUsage;
  if (command.individual.empty()) {
    auto loaded = LoadWithMap(from.file, command.allow_range, io, from.place);
    if (!loaded) return Exit::kBadInput;
    return std::move(*loaded);
  }
  auto found = FindRobot({from.file, command.individual, command.environments,
                          command.allow_range},
                         io);
  if (!found) return found.error();
  return std::move(found->loaded);
}

Exit Explain(const LoadedProgram& loaded, const Question& question,
             const WhyCommand& command, Io& io) {
  const Program& program = loaded.mapped.program;
  const Genotype& genotype = program.genotype;
  const auto environments =
      ChooseEnvironments(program, command.environments, io);
  if (!environments) return Exit::kBadUsage;
  if (question.place && command.format == OutputFormat::kText) {
    const Occurrence written = OccurrenceAt(genotype, *question.place);
    io.out
        << fmt::format("{} of {}\n", SymbolText(genotype, written),
                       RuleText(genotype, written.rule))
        << RenderPlace(
               loaded.mapped.map.rules[written.rule].symbols[written.position],
               "", loaded.source);
  }
  bool is_found = false;
  for (const NamedEnvironment& named : *environments) {
    const auto history = DevelopWithHistory(genotype, named.environment);
    if (!history) {
      ReportGrowth(loaded, named, io);
      return Exit::kBadInput;
    }
    const HistoryView view{loaded.source, genotype, loaded.mapped.map,
                           named.environment, *history};
    if (question.part) {
      is_found |= ExplainPart(view, named, *question.part, command.format, io);
    } else {
      ExplainSymbol(view, named, *question.place, command.format, io);
      is_found = true;
    }
  }
  return is_found ? Exit::kFine : Exit::kBadInput;
}

}  // namespace

Exit Run(const WhyCommand& command, Io& io) {
  const FileAndPlace from = Split(command.file);
  Question question{PartOf(command), std::nullopt};
  if (question.part.has_value() == from.place.has_value()) {
    io.err << "plsc: ask for one of FILE:LINE:COLUMN, --module, --node or "
              "--edge\nsee 'plsc why --help'\n";
    return Exit::kBadUsage;
  }
  const auto found = Load(command, from, io);
  if (!found) return found.error();
  const auto& loaded = *found;
  const Genotype& genotype = loaded.mapped.program.genotype;
  if (question.part && !genotype.alphabet->is_built_in()) {
    io.err << fmt::format("error: alphabet '{}' has no bodies to ask about\n",
                          genotype.alphabet->name());
    return Exit::kBadUsage;
  }
  if (from.place) {
    question.place = FindPlace(loaded, *from.place, io);
    if (!question.place) return Exit::kBadUsage;
  }
  return Explain(loaded, question, command, io);
}

}  // namespace plsc::cli
