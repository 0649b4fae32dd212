#include "runtime/life/season_quantities.h"

#include <cassert>

#include "runtime/develop/descriptors.h"
#include "runtime/formula/quantities.h"

namespace plsc {

std::vector<double> QuantitiesOf(const SeasonResult& result,
                                 const Season& season) {
  std::vector<double> values;
  values.reserve(Quantities().size());
  const auto add = [&](const std::vector<NamedValue>& list) {
    for (const NamedValue& one : list) values.push_back(one.value);
  };
  add(List(result.body));
  add(List(result.brain));
  add(List(result.behaviour));
  const double duration =
      static_cast<double>(result.steps) * season.physics.step;
  values.push_back(duration);
  values.push_back(result.behaviour.displacement_velocity * duration);
  values.push_back(result.behaviour.velocity * duration);
  assert(values.size() == Quantities().size());
  return values;
}

}  // namespace plsc
