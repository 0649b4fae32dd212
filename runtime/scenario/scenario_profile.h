#pragma once

// The named sets of values that a scenario starts from. Nothing but values: a
// scenario that writes all of them out is the same under any profile. Where
// each number comes from is in docs/simulation.md.

#include "runtime/scenario/scenario.h"

namespace plsc {

/// All that seasons share; no seasons.
Scenario ProfileScenario(Profile profile);

/// A season of that ground, without senses.
Season ProfileSeason(Profile profile, const Terrain& terrain);

/// The paper's seasons under the profile: 50 s Flat, then 50 s Tilted by 5
/// degrees, `hot` False in both. `inclined` is sensed; as the authors' program
/// ran them it is given, by the name of the world (plasticoding.py:183).
Scenario BothSeasons(Profile profile);

Scenario PaperScenario();
Scenario PublishedScenario();

}  // namespace plsc
