#pragma once

// Selection by tournaments (paper, "Evolution"; authors' program,
// selection.py:6): of parents and of survivors. Both take distinct individuals;
// neither keeps an elite.

#include <cstddef>
#include <functional>
#include <vector>

#include "runtime/vary/rng.h"

namespace plsc {

/// `size` contestants drawn uniformly with replacement; the best score wins,
/// of equal ones the first drawn. Returns an index into `scores`.
std::size_t Tournament(const std::vector<int>& scores, int size, Rng& rng);

/// Winners of tournaments over all of `scores`, in order of winning, until
/// `count` different ones have won. `count` <= scores.size(). Fewer where
/// `should_stop`, asked between winners, says so.
std::vector<std::size_t> SelectDistinct(
    const std::vector<int>& scores, std::size_t count, int tournament_size,
    Rng& rng, const std::function<bool()>& should_stop = {});

}  // namespace plsc
