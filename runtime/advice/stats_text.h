#pragma once

// Statistics of a genotype for people and for scripts.

#include <string>

#include "compiler/genotype.h"
#include "runtime/advice/genotype_stats.h"

namespace plsc {

/// Some lines, the last with an end; a column an environment.
std::string StatsText(const Genotype& genotype, const GenotypeStats& stats);

/// One line without its end. `path` as the user wrote it.
std::string StatsJson(const std::string& path, const Genotype& genotype,
                      const GenotypeStats& stats);

}  // namespace plsc
