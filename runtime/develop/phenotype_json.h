#pragma once

// A developed robot as one JSON object: the string, the body as a tree, the
// brain, the descriptors. The shape in which results of the authors' program
// are compared with ours (docs/formats.md).

#include <string>

#include "compiler/genotype.h"
#include "runtime/develop/derive.h"
#include "sim/phenotype.h"

namespace plsc {

/// What `plsc develop --format json` prints for one environment: a line
/// without its end. Keys: genotype, environment (state -> value), active_rules
/// (numbers from 1, in file order), early, and, when the alphabet has bodies
/// (`phenotype` not null), body, brain, body_descriptors, brain_descriptors.
std::string DevelopmentJson(const Genotype& genotype,
                            const Environment& environment,
                            const SymbolString& string,
                            const Phenotype* phenotype);

/// What DevelopmentJson has under "body": the core, with its children.
std::string BodyJson(const Body& body);

/// What it has under "brain"; of the phenotype, as nodes name their modules.
std::string BrainJson(const Phenotype& phenotype);

}  // namespace plsc
