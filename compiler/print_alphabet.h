#pragma once

// The alphabet item of a genotype file, as Print and Format write it.

#include <string>

#include "compiler/alphabet.h"

namespace plsc {

/// `alphabet plasticoding 1`, or a file's own with one group of symbols a
/// line. Ends in a newline.
std::string PrintAlphabet(const Alphabet& alphabet);

}  // namespace plsc
