#include <nlohmann/json.hpp>

#include "compiler/print.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/service/asks.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"

namespace plsc::service {

namespace {

std::string DevelopedJson(const Genotype& genotype,
                          const NamedEnvironment& named) {
  const ActiveRules active = Regulate(genotype, named.environment);
  const auto string = Derive(genotype, active);
  // The last string has few enough, and one on the way to it had not.
  if (!string)
    throw Refusal("in " + named.name + ", development has too many symbols");
  std::optional<Phenotype> robot;
  if (genotype.alphabet->is_built_in()) robot = Develop(genotype, *string);
  return DevelopmentJson(genotype, named.environment, *string,
                         robot ? &*robot : nullptr);
}

}  // namespace

Answer DevelopAll(const Request& request) {
  const Subject subject = SubjectOf(request);
  const auto environments = EnvironmentsOf(request, subject);
  RefuseGrowth(subject, environments);
  std::string all;
  for (const NamedEnvironment& named : environments) {
    Answer one;
    one.Add("name", named.name);
    one.Add("senses",
            PrintEnvironment(named.environment, subject.genotype().states));
    one.AddWritten("development", DevelopedJson(subject.genotype(), named));
    if (!all.empty()) all += ',';
    all += "{" + one.members() + "}";
  }
  Answer answer;
  answer.AddWritten("environments", "[" + all + "]");
  return answer;
}

}  // namespace plsc::service
