#pragma once

// What a robot did in one season, as one JSON object.

#include <string>

#include "compiler/genotype.h"
#include "runtime/life/season_result.h"

namespace plsc {

/// What `plsc simulate --format json` prints a season: genotype, season,
/// profile, begin (s since birth), sensed (by state: value as EnvironmentJson
/// has it, from "imu", "season" or "parent"), inclination (rad or null), change
/// ("born", "none", "brain", "body"), change_reason, outcome, reason, fitness
/// (m/s or null), behaviour (or null), body_descriptors, brain_descriptors
/// (null without a robot), steps, solver_warnings, state_hash (16 hexadecimal
/// digits). A line without its end.
std::string SeasonJson(const Genotype& genotype, const SeasonResult& result);

/// `"fitness":{season: m/s or null},"seasons":[as SeasonJson]`: what answers
/// about a whole life have, without the brackets of an object.
std::string EvaluationJson(const Genotype& genotype,
                           const Evaluation& evaluation);

}  // namespace plsc
