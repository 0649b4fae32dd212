#pragma once

// An evaluated individual for people: its seasons with what it did, and the
// body that developed for each.

#include <string>

#include "runtime/evolve/individual.h"

namespace plsc::cli {

/// "season flat: speed 2.660 cm/s, balance 0.9871, 7 modules".
std::string SeasonLine(const SeasonResult& result);

/// Each season's line and drawing; "not evaluated yet" if there is none.
std::string SeasonsText(const Individual& one);

}  // namespace plsc::cli
