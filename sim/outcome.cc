#include "sim/outcome.h"

#include <cassert>

namespace plsc {

std::string_view OutcomeName(Outcome outcome) {
  for (const auto& [one, name] : kOutcomeNames)
    if (one == outcome) return name;
  assert(false);
  return "";
}

}  // namespace plsc
