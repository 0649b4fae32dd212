#pragma once

// The two figures of a paper as SVG, drawn without a browser: boxes of the
// generation that is compared, and curves over generations. A panel a measure
// and season. What the page draws can be explored; this can be made by a
// script.

#include <string>

#include "runtime/report/report.h"

namespace plsc {

/// A box an experiment, as Finals has it, with a dot a run and a diamond for
/// the mean: of relived values where runs have them, beside the recorded ones.
std::string BoxesFigure(const StudyReport& report);

/// Medians over runs of the populations' means, quartiles as a band.
std::string CurvesFigure(const StudyReport& report);

}  // namespace plsc
