#include "runtime/relive/displacement.h"

#include "runtime/vary/rng.h"

namespace plsc {

Disturbances DisplacedStarts(std::uint64_t seed, int id, int n,
                             std::size_t seasons) {
  Rng rng({seed, static_cast<std::uint64_t>(n), static_cast<std::uint64_t>(id),
           Purpose::kRelive});
  Disturbances starts(seasons);
  for (Disturbance& start : starts) start.lift = rng.Uniform(0, kMostLift);
  return starts;
}

}  // namespace plsc
