#pragma once

// What reports show of robots and claims speak of: the one table from the
// paper's names and units to the columns of a store. Knows no numbers of any
// run.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"

namespace plsc {

/// The table of a store that has the column.
enum class MeasureSource : std::uint8_t {
  kBehaviour,   ///< simulation; NULL unless the life was completed
  kBody,        ///< body
  kBrain,       ///< phenotype
  kEvaluation,  ///< evaluation
};

struct ReportMeasure {
  std::string id;     ///< the column: "displacement_velocity_hill"
  std::string title;  ///< "Speed"
  std::string unit;   ///< of the shown numbers; empty: none
  double scale = 1;   ///< of the stored number to the shown one
  MeasureSource source = MeasureSource::kBody;

  friend bool operator==(const ReportMeasure&, const ReportMeasure&) = default;
};

/// Speed, Balance, Size, Sensors, Sensors Reach, Recurrence: the paper's
/// figures, in the order of behaviour, body, brain.
std::vector<ReportMeasure> PaperMeasures();
/// These, and then every other descriptor and the fitness.
std::vector<ReportMeasure> AllMeasures();

/// `text`: "paper", "all", or columns or titles with commas between them, in
/// any case: "speed,hinge_count". Fails with what is unknown and what there is.
Expected<std::vector<ReportMeasure>, Failure> ChooseMeasures(
    std::string_view text);

/// The id of the fitness.
inline constexpr const char* kFitnessMeasure = "fitness";

/// Fitness as it is stored, where it is a formula's and no speed.
void UseOwnFitness(std::vector<ReportMeasure>& measures);

/// By column or title, in any case.
std::optional<ReportMeasure> FindMeasure(std::string_view name);

/// As it is typed: its title in small letters, '_' for blanks. No other's.
std::string MeasureName(const ReportMeasure& measure);

}  // namespace plsc
