#pragma once

// What a request is about: a genotype of its text, environments, a scenario.
// What is wrong with them, or is more than the limits allow, is a Refusal.

#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/develop/derive.h"
#include "runtime/scenario/scenario.h"
#include "runtime/service/limits.h"
#include "runtime/service/request.h"
#include "sim/phenotype.h"

namespace plsc::service {

/// A text under a key that must be there.
std::string LimitedText(const Request& request, std::string_view key,
                        std::size_t most = kMostTextBytes);
/// The key `name`.
std::string NameOf(const Request& request);
/// The keys `text` and `name`.
Source TextOf(const Request& request);

struct Subject {
  Source source;
  MappedProgram mapped;
  std::vector<Diagnostic> warnings;  ///< of the whole text

  const Genotype& genotype() const { return mapped.program.genotype; }
};
/// The keys `text`, `name` and `genotype`.
Subject SubjectOf(const Request& request);

/// The keys `scenario` and `engine`; without the first the paper's, in the
/// engine that all builds have.
Scenario ScenarioOf(const Request& request);
/// Before a life, or a robot that is put down to feel the ground.
void RefuseMissingEngine(const Scenario& scenario);
/// What a scenario's text is called in diagnostics.
inline constexpr const char* kScenarioName = "scenario.yaml";

/// The key `environment`. Without it those that the text names; of a text
/// without any, what is sensed in the seasons of the key `scenario`.
std::vector<NamedEnvironment> EnvironmentsOf(const Request& request,
                                             const Subject& subject);

/// Refuses an alphabet without bodies; `purpose` ends "alphabet 'x' has no
/// bodies to".
void RefuseBodiless(const Genotype& genotype, const char* purpose);

/// Refuses what would develop into more symbols than may be, in all of the
/// environments together.
void RefuseGrowth(const Subject& subject,
                  const std::vector<NamedEnvironment>& environments);

}  // namespace plsc::service
