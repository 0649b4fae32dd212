#include "runtime/cli/files/load_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <ostream>
#include <system_error>
#include <utility>

#include "compiler/named_environments.h"
#include "grammar/shown_line.h"
#include "grammar/suggest.h"
#include "runtime/advice/lint.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/growth.h"

namespace plsc::cli {

namespace {

std::optional<NamedEnvironment> ReadOne(const Program& program,
                                        const std::string& text, Io& io) {
  const Source source("--env", text);
  Result<NamedEnvironment> found = FindEnvironment(program, source);
  Report(found.diagnostics(), source, io);
  if (found) return std::move(*found);
  if (!program.environments.empty() && text.find('=') == std::string::npos) {
    io.err << "= note: environments that the file names:";
    for (const NamedEnvironment& named : program.environments)
      io.err << ' ' << Escaped(named.name);
    io.err << '\n';
  }
  return std::nullopt;
}

CompileOptions Options(bool allow_range) {
  CompileOptions options;
  options.allow_out_of_range = allow_range;
  return options;
}

// Prints what is wrong; warnings are for WarnOf, when it is known whose.
std::optional<std::vector<MappedProgram>> Compiled(
    const Source& source, bool allow_range, std::vector<Diagnostic>& warnings,
    Io& io) {
  auto all = CompileAllWithMap(source, Options(allow_range));
  if (!all) {
    Report(all.diagnostics(), source, io);
    return std::nullopt;
  }
  warnings = all.diagnostics();
  return std::move(*all);
}

// Prints the warnings of the chosen genotypes, and of what belongs to all: a
// section goes from its genotype's name to the next one's.
void WarnOf(const std::vector<std::size_t>& chosen,
            const std::vector<MappedProgram>& all,
            std::vector<Diagnostic> warnings, const Source& source, Io& io) {
  const auto is_other = [&](const Diagnostic& warning) {
    const auto next =
        std::upper_bound(all.begin(), all.end(), warning.span.begin,
                         [](std::uint32_t at, const MappedProgram& one) {
                           return at < one.map.genotype.begin;
                         });
    const auto owner = static_cast<std::size_t>(next - all.begin());
    return owner > 0 &&
           !std::binary_search(chosen.begin(), chosen.end(), owner - 1);
  };
  if (all.size() > 1) std::erase_if(warnings, is_other);
  Report(warnings, source, io);
}

// The genotype that alone has a symbol there.
std::optional<std::size_t> WrittenAt(const std::vector<MappedProgram>& all,
                                     Position at, const Source& source) {
  const auto offset = source.OffsetOf(at);
  if (!offset) return std::nullopt;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!FindSymbol(all[i].map, *offset)) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

// The genotype of that name, or the only one. Prints what is wrong.
std::optional<std::size_t> Choose(const std::vector<MappedProgram>& all,
                                  const std::string& name, const Source& source,
                                  Io& io) {
  if (name.empty()) {
    if (all.size() == 1) return 0;
    Report({SeveralGenotypes(source)}, source, io);
    return std::nullopt;
  }
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    names.push_back(all[i].program.genotype.name);
    if (names.back() == name) return i;
  }
  io.err << RenderWithoutLine(
      {Code::kSeveralGenotypes,
       {},
       fmt::format("{} has no genotype '{}'", source.name(), name)});
  if (const auto near = Suggest(name, names))
    io.err << fmt::format("  = help: did you mean '{}'?\n", *near);
  else
    io.err << fmt::format("  = note: it holds {}\n", fmt::join(names, ", "));
  return std::nullopt;
}

}  // namespace

GenotypePath SplitGenotypePath(const std::string& path) {
  const std::size_t hash = path.rfind('#');
  std::error_code ignored;
  if (hash == std::string::npos || std::filesystem::exists(path, ignored))
    return {path, ""};
  return {path.substr(0, hash), path.substr(hash + 1)};
}

std::optional<LoadedProgram> LoadWithMap(const std::string& path,
                                         bool allow_range, Io& io,
                                         const std::optional<Position>& at) {
  const GenotypePath from = SplitGenotypePath(path);
  std::optional<Source> source = ReadOrReport(from.file, io);
  if (!source) return std::nullopt;
  std::vector<Diagnostic> warnings;
  auto all = Compiled(*source, allow_range, warnings, io);
  if (!all) return std::nullopt;
  std::optional<std::size_t> chosen;
  if (at && from.genotype.empty()) chosen = WrittenAt(*all, *at, *source);
  if (!chosen) chosen = Choose(*all, from.genotype, *source, io);
  if (!chosen) return std::nullopt;
  WarnOf({*chosen}, *all, std::move(warnings), *source, io);
  return LoadedProgram{std::move(*source), std::move((*all)[*chosen])};
}

std::optional<LoadedFile> LoadFile(const std::string& path, bool allow_range,
                                   Io& io) {
  const GenotypePath from = SplitGenotypePath(path);
  std::optional<Source> source = ReadOrReport(from.file, io);
  if (!source) return std::nullopt;
  std::vector<Diagnostic> warnings;
  auto all = Compiled(*source, allow_range, warnings, io);
  if (!all) return std::nullopt;
  std::vector<std::size_t> chosen(all->size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  if (!from.genotype.empty()) {
    const auto one = Choose(*all, from.genotype, *source, io);
    if (!one) return std::nullopt;
    chosen = {*one};
  }
  WarnOf(chosen, *all, std::move(warnings), *source, io);
  return LoadedFile{std::move(*source), std::move(*all), std::move(chosen)};
}

std::string PathOf(const LoadedFile& file, std::size_t genotype) {
  if (file.all.size() == 1) return file.source.name();
  return file.source.name() + '#' + file.all[genotype].program.genotype.name;
}

std::optional<Program> LoadProgram(const std::string& path, bool allow_range,
                                   Io& io) {
  auto loaded = LoadWithMap(path, allow_range, io);
  if (!loaded) return std::nullopt;
  return std::move(loaded->mapped.program);
}

void ReportGrowth(const LoadedProgram& loaded, const NamedEnvironment& named,
                  Io& io) {
  const Genotype& genotype = loaded.mapped.program.genotype;
  const ActiveRules active = Regulate(genotype, named.environment);
  const std::uint64_t length = DerivedLength(genotype, active);
  if (length > kMaxStringLength) {
    Report({GrowthError(loaded.mapped, active, length, named.name)},
           loaded.source, io);
    return;
  }
  io.err << fmt::format(
      "error: in {}, the history of development has too many symbols to be "
      "kept\n",
      Escaped(named.name));
}

std::optional<std::vector<NamedEnvironment>> ChooseEnvironments(
    const Program& program, const std::vector<std::string>& texts, Io& io) {
  if (!texts.empty()) {
    std::vector<NamedEnvironment> chosen;
    for (const std::string& text : texts) {
      std::optional<NamedEnvironment> one = ReadOne(program, text, io);
      if (!one) return std::nullopt;
      chosen.push_back(std::move(*one));
    }
    return chosen;
  }
  if (auto usual = UsualEnvironments(program)) return usual;
  io.err << fmt::format(
      "error: which environment? the genotype senses its surroundings and the "
      "file names none\n  = help: add --env {}\n",
      ExampleOfEnvironment(program.genotype.states));
  return std::nullopt;
}

}  // namespace plsc::cli
