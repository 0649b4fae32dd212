#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "compiler/print.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/descriptors.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/growth.h"
#include "runtime/develop/part_names.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/history/history_json.h"
#include "runtime/history/history_text.h"
#include "runtime/pictures/body_svg.h"
#include "runtime/pictures/body_text.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

/// What development goes through.
struct Stages {
  ActiveRules active;
  SymbolString string;
  std::optional<Phenotype> phenotype;  ///< of alphabets that have bodies
};

std::optional<Stages> DevelopIn(const Genotype& genotype,
                                const Environment& environment) {
  Stages developed;
  developed.active = Regulate(genotype, environment);
  std::optional<SymbolString> string = Derive(genotype, developed.active);
  if (!string) return std::nullopt;
  developed.string = std::move(*string);
  if (genotype.alphabet->is_built_in())
    developed.phenotype = Develop(genotype, developed.string);
  return developed;
}

void PrintSymbols(const Genotype& genotype, const SymbolString& string,
                  std::ostream& out) {
  for (const Occurrence& occurrence : string) {
    out << ' ' << SymbolText(genotype, occurrence);
  }
}

// The derivation as the paper prints it, an iteration a line.
void PrintDerivation(const Genotype& genotype, const ActiveRules& active,
                     std::ostream& out) {
  const auto steps = DeriveSteps(genotype, active);
  for (std::size_t i = 0; steps && i < steps->size(); ++i) {
    out << fmt::format("Iteration {}:", i);
    PrintSymbols(genotype, (*steps)[i], out);
    out << '\n';
  }
}

void PrintBody(const Phenotype& phenotype, std::ostream& out) {
  const BodyDescriptors body = DescribeBody(phenotype.body);
  const BrainDescriptors brain = DescribeBrain(phenotype);
  out << BodyText(phenotype.body);
  out << fmt::format(
      "{} modules: core, {} bricks, {} joints; {} touch sensors\n"
      "brain: {} nodes, {} edges; sensors reach {:.2f}, recurrence {:.2f}\n",
      body.absolute_size, body.brick_count, body.hinge_count,
      body.touch_sensor_count, phenotype.brain.nodes.size(),
      phenotype.brain.connections.size(), brain.sensors_reach,
      brain.recurrence);
}

void PrintText(const Genotype& genotype, const NamedEnvironment& named,
               const Stages& developed, std::ostream& out) {
  const std::string senses =
      PrintEnvironment(named.environment, genotype.states);
  out << fmt::format("{} in {}", genotype.name, Escaped(named.name));
  if (!senses.empty() && senses != named.name) out << " (" << senses << ")";
  out << fmt::format(": {} of {} rules active, {} symbols\n",
                     developed.active.rules.size(), genotype.rules.size(),
                     developed.string.size());
  if (developed.phenotype) PrintBody(*developed.phenotype, out);
}

// "gecko-inclined_True.svg": a name that every file system takes.
std::string FileName(const std::string& genotype,
                     const std::string& environment) {
  std::string name = genotype + "-" + environment;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  return name + ".svg";
}

Output PictureOf(const DevelopCommand& command, const Genotype& genotype,
                 const NamedEnvironment& named) {
  const std::filesystem::path folder = command.svg_folder;
  return {(folder / FileName(genotype.name, named.name)).string(),
          OutputKind::kSvg,
          command.force,
          {SplitGenotypePath(command.file).file}};
}

bool CanWriteAll(const DevelopCommand& command, const Genotype& genotype,
                 const std::vector<NamedEnvironment>& environments, Io& io) {
  if (command.svg_folder.empty()) return true;
  return MakeFolder(command.svg_folder, io) &&
         std::all_of(environments.begin(), environments.end(),
                     [&](const NamedEnvironment& named) {
                       return CanWrite(PictureOf(command, genotype, named), io);
                     });
}

bool WriteSvg(const DevelopCommand& command, const Genotype& genotype,
              const NamedEnvironment& named, const Body& body, Io& io) {
  const Output output = PictureOf(command, genotype, named);
  if (!WriteOutput(output, BodySvg(body, genotype.name + ", " + named.name),
                   io))
    return false;
  io.err << fmt::format("wrote {}\n", Escaped(output.path));
  return true;
}

std::string JsonText(const Genotype& genotype, const Environment& environment,
                     const Stages& developed, const HistoryView* view) {
  const Phenotype* phenotype =
      developed.phenotype ? &*developed.phenotype : nullptr;
  std::string text =
      DevelopmentJson(genotype, environment, developed.string, phenotype);
  if (view == nullptr) return text;
  auto json = nlohmann::ordered_json::parse(text);
  json["trace"] = HistoryJson(*view);
  // The file's name may be any bytes; JSON must stay UTF-8.
  return DumpJson(json);
}

// False when the history outgrows its limit.
bool Print(const DevelopCommand& command, const LoadedProgram& loaded,
           const NamedEnvironment& named, const Stages& developed, Io& io) {
  const Genotype& genotype = loaded.mapped.program.genotype;
  std::optional<History> history;
  std::optional<HistoryView> view;
  if (command.trace) {
    history = DevelopWithHistory(genotype, named.environment);
    if (!history) return false;
    view.emplace(HistoryView{loaded.source, genotype, loaded.mapped.map,
                             named.environment, *history});
  }
  if (command.format == OutputFormat::kJson) {
    io.out << JsonText(genotype, named.environment, developed,
                       view ? &*view : nullptr)
           << '\n';
    return true;
  }
  PrintText(genotype, named, developed, io.out);
  if (view)
    io.out << HistoryText(*view);
  else if (!developed.phenotype)
    PrintDerivation(genotype, developed.active, io.out);
  io.out << '\n';
  return true;
}

}  // namespace

Exit Run(const DevelopCommand& command, Io& io) {
  const auto loaded = LoadWithMap(command.file, command.allow_range, io);
  if (!loaded) return Exit::kBadInput;
  const Program& program = loaded->mapped.program;
  const Genotype& genotype = program.genotype;
  if (!command.svg_folder.empty() && !genotype.alphabet->is_built_in()) {
    io.err << fmt::format(
        "error: --svg draws bodies, and alphabet '{}' has "
        "none\n",
        genotype.alphabet->name());
    return Exit::kBadUsage;
  }
  const auto environments =
      ChooseEnvironments(program, command.environments, io);
  if (!environments) return Exit::kBadUsage;
  if (!CanWriteAll(command, genotype, *environments, io))
    return Exit::kBadInput;

  for (const NamedEnvironment& named : *environments) {
    const auto developed = DevelopIn(genotype, named.environment);
    if (!developed || !Print(command, *loaded, named, *developed, io)) {
      ReportGrowth(*loaded, named, io);
      return Exit::kBadInput;
    }
    if (!command.svg_folder.empty() &&
        !WriteSvg(command, genotype, named, developed->phenotype->body, io))
      return Exit::kBadInput;
  }
  return Exit::kFine;
}

}  // namespace plsc::cli
