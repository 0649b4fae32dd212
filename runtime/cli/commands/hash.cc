#include <fmt/format.h>

#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/develop/developed.h"
#include "runtime/develop/genotype_key.h"

namespace plsc::cli {

namespace {

// Of the robot in each environment. Whether it could be developed.
Exit HashRobots(const LoadedFile& file, std::size_t index,
                const HashCommand& command, Io& io) {
  const Program& program = file.all[index].program;
  const auto environments =
      ChooseEnvironments(program, command.environments, io);
  if (!environments) return Exit::kBadUsage;
  for (const NamedEnvironment& named : *environments) {
    const auto developed = DevelopActive(
        program.genotype, Regulate(program.genotype, named.environment));
    if (!developed) {
      ReportGrowth({file.source, file.all[index]}, named, io);
      return Exit::kBadInput;
    }
    io.out << fmt::format("{}  {}@{}\n",
                          Hex(DevelopedKey(program.genotype, *developed)),
                          Escaped(PathOf(file, index)), named.name);
  }
  return Exit::kFine;
}

Exit HashFile(const std::string& path, const HashCommand& command, Io& io) {
  const auto file = LoadFile(path, command.allow_range, io);
  if (!file) return Exit::kBadInput;
  for (const std::size_t index : file->chosen) {
    if (command.phenotype) {
      const Exit exit = HashRobots(*file, index, command, io);
      if (exit != Exit::kFine) return exit;
      continue;
    }
    io.out << fmt::format("{}  {}\n",
                          Hex(GenotypeKey(file->all[index].program.genotype)),
                          Escaped(PathOf(*file, index)));
  }
  return Exit::kFine;
}

}  // namespace

Exit Run(const HashCommand& command, Io& io) {
  Exit worst = Exit::kFine;
  for (const std::string& file : command.files) {
    const Exit exit = HashFile(file, command, io);
    if (exit != Exit::kFine) worst = exit;
  }
  return worst;
}

}  // namespace plsc::cli
