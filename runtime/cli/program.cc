#include "runtime/cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include "compiler/print.h"
#include "runtime/environment.h"

namespace plsc::cli {

namespace {

std::string ExampleOf(const std::vector<State>& states) {
  Environment example;
  for (const State& state : states)
    example.values.push_back(state.type == StateType::kReal ? state.low : 0);
  return PrintEnvironment(example, states);
}

const NamedEnvironment* Find(const Program& program, std::string_view name) {
  const auto found =
      std::find_if(program.environments.begin(), program.environments.end(),
                   [&](const NamedEnvironment& e) { return e.name == name; });
  return found == program.environments.end() ? nullptr : &*found;
}

std::optional<NamedEnvironment> ReadOne(const Program& program,
                                        const std::string& text, Io& io) {
  if (const NamedEnvironment* named = Find(program, text)) return *named;
  const Source source("--env", text);
  const Result<Environment> environment =
      ParseEnvironment(source, program.genotype.states);
  Report(environment.diagnostics(), source, io);
  if (!environment) {
    if (!program.environments.empty() && text.find('=') == std::string::npos) {
      io.err << "= note: environments that the file names:";
      for (const NamedEnvironment& named : program.environments)
        io.err << ' ' << named.name;
      io.err << '\n';
    }
    return std::nullopt;
  }
  std::string name = PrintEnvironment(*environment, program.genotype.states);
  return NamedEnvironment{std::move(name), *environment};
}

}  // namespace

std::optional<LoadedProgram> LoadWithSource(const std::string& path,
                                            bool allow_range, Io& io) {
  Result<Source> source = ReadSource(path, io);
  if (!source) {
    io.err << fmt::format("error[{}]: {}\n", source.diagnostics()[0].code,
                          source.diagnostics()[0].message);
    return std::nullopt;
  }
  CompileOptions options;
  options.allow_out_of_range = allow_range;
  Result<MappedProgram> compiled = CompileWithMap(*source, options);
  Report(compiled.diagnostics(), *source, io);
  if (!compiled) return std::nullopt;
  return LoadedProgram{std::move(*source), std::move(*compiled)};
}

std::optional<Program> LoadProgram(const std::string& path, bool allow_range,
                                   Io& io) {
  auto loaded = LoadWithSource(path, allow_range, io);
  if (!loaded) return std::nullopt;
  return std::move(loaded->compiled.program);
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
  if (!program.environments.empty()) return program.environments;
  if (program.genotype.states.empty())
    return std::vector<NamedEnvironment>{{"any", {}}};
  io.err << fmt::format(
      "error: which environment? the genotype senses its surroundings and the "
      "file names none\n  = help: add --env {}\n",
      ExampleOf(program.genotype.states));
  return std::nullopt;
}

}  // namespace plsc::cli
