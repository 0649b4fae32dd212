#pragma once

// Which children the authors' program can make by one mutation, said as the
// set of all of them (standard_mutation.py at the paper's commit; two rules a
// letter, two terms a clause).

#include "compiler/genotype.h"

namespace plsc::test {

/// Whether `child` is `parent` after one of its mutations, or after one that
/// changed nothing. Where symbols are found by place and may be appended, as
/// the paper says, with `as_in_paper`.
bool AuthorsCanMake(const Genotype& parent, const Genotype& child,
                    bool as_in_paper);

}  // namespace plsc::test
