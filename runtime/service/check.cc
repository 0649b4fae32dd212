#include <nlohmann/json.hpp>

#include "compiler/format.h"
#include "runtime/advice/lint.h"
#include "runtime/develop/environment_json.h"
#include "runtime/service/asks.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"
#include "runtime/text/diagnostic_json.h"

namespace plsc::service {

namespace {

using Json = nlohmann::ordered_json;

Json StateJson(const State& state) {
  Json json;
  json["name"] = state.name;
  switch (state.type) {
    case StateType::kBool:
      json["type"] = "bool";
      break;
    case StateType::kReal:
      json["type"] = "real";
      json["low"] = state.low;
      json["high"] = state.high;
      break;
    case StateType::kEnum:
      json["type"] = "enum";
      json["values"] = state.values;
      break;
  }
  return json;
}

Json GenotypeJson(const Program& program) {
  const Genotype& genotype = program.genotype;
  Json json;
  json["name"] = genotype.name;
  json["alphabet"] = genotype.alphabet->name();
  json["has_bodies"] = genotype.alphabet->is_built_in();
  json["rules"] = genotype.rules.size();
  json["states"] = Json::array();
  for (const State& state : genotype.states)
    json["states"].push_back(StateJson(state));
  json["environments"] = Json::array();
  for (const NamedEnvironment& named : program.environments)
    json["environments"].push_back(
        {{"name", named.name},
         {"senses", EnvironmentJson(named.environment, genotype.states)}});
  return json;
}

}  // namespace

Answer Check(const Request& request) {
  const Source source = TextOf(request);
  const auto compiled = CompileAllWithMap(source);
  std::vector<Diagnostic> diagnostics = compiled.diagnostics();
  if (compiled && request.Flag("lint"))
    for (Diagnostic& warning : Lint(*compiled, source))
      diagnostics.push_back(std::move(warning));
  Json genotypes = Json::array();
  if (compiled)
    for (const MappedProgram& mapped : *compiled)
      genotypes.push_back(GenotypeJson(mapped.program));
  Answer answer;
  answer.Add("fine", static_cast<bool>(compiled));
  answer.AddWritten("diagnostics",
                    "[" + DiagnosticsJson(diagnostics, source) + "]");
  answer.Add("genotypes", genotypes);
  return answer;
}

Answer FormatText(const Request& request) {
  const Source source = TextOf(request);
  const Result<std::string> formatted = Format(source);
  if (!formatted) throw Refusal(formatted.diagnostics(), source);
  Answer answer;
  answer.Add("text", *formatted);
  answer.Add("changed", *formatted != source.text());
  return answer;
}

}  // namespace plsc::service
