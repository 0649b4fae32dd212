#include "runtime/study/report_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "runtime/formula/quantities.h"
#include "runtime/store/schema.h"
#include "runtime/text/quantity.h"

namespace plsc {

namespace {

using Measures = std::vector<ReportMeasure>;

// Speeds are m/s in stores and cm/s in the paper.

bool Has(const Measures& measures, const std::string& id) {
  return std::any_of(
      measures.begin(), measures.end(),
      [&](const ReportMeasure& measure) { return measure.id == id; });
}

/// "length_of_limbs" to "Length of limbs".
std::string TitleOf(std::string id) {
  std::replace(id.begin(), id.end(), '_', ' ');
  id[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(id[0])));
  return id;
}

bool IsSpeed(const std::string& id) {
  return id.find("velocity") != std::string::npos;
}

/// As shown.
std::string UnitOf(const std::string& id) {
  if (IsSpeed(id)) return "cm/s";
  if (id.find("servo_error") != std::string::npos) return "rad/s";
  const auto quantity = FindQuantity(id);
  return quantity ? std::string(Quantities()[*quantity].unit) : "";
}

void AddOthers(const std::vector<std::string>& columns, MeasureSource source,
               Measures& all) {
  for (const std::string& id : columns)
    if (!Has(all, id))
      all.push_back({id, TitleOf(id), UnitOf(id),
                     IsSpeed(id) ? kCentimetres : 1, source});
}

/// Small letters, '_' for blanks.
std::string Folded(std::string_view text) {
  std::string folded;
  for (const char c : text)
    folded +=
        c == ' '
            ? '_'
            : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t begin = folded.find_first_not_of('_');
  if (begin == std::string::npos) return "";
  return folded.substr(begin, folded.find_last_not_of('_') + 1 - begin);
}

/// `name` is folded.
Measures::const_iterator FindIn(const Measures& all, const std::string& name) {
  return std::find_if(
      all.begin(), all.end(), [&](const ReportMeasure& measure) {
        return measure.id == name || Folded(measure.title) == name;
      });
}

std::vector<std::string> SplitNames(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(Folded(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

Measures PaperMeasures() {
  using enum MeasureSource;
  return {
      {"displacement_velocity_hill", "Speed", "cm/s", kCentimetres, kBehaviour},
      {"head_balance", "Balance", "", 1, kBehaviour},
      {"absolute_size", "Size", "modules", 1, kBody},
      {"sensors", "Sensors", "", 1, kBody},
      {"sensors_reach", "Sensors Reach", "", 1, kBrain},
      {"recurrence", "Recurrence", "", 1, kBrain},
  };
}

Measures AllMeasures() {
  Measures all = PaperMeasures();
  all.push_back({kFitnessMeasure, "Fitness", "cm/s", kCentimetres,
                 MeasureSource::kEvaluation});
  AddOthers(BehaviourColumns(), MeasureSource::kBehaviour, all);
  AddOthers(BodyColumns(), MeasureSource::kBody, all);
  AddOthers(BrainColumns(), MeasureSource::kBrain, all);
  return all;
}

Expected<Measures, Failure> ChooseMeasures(std::string_view text) {
  if (text == "paper") return PaperMeasures();
  const Measures all = AllMeasures();
  if (text == "all") return all;
  std::vector<std::string> names;
  for (const ReportMeasure& measure : all) names.push_back(measure.id);
  Measures chosen;
  for (const std::string& name : SplitNames(text)) {
    const auto found = FindIn(all, name);
    if (found == all.end())
      return Failure(fmt::format(
          "unknown measure '{}'; there are paper, all, or any of speed, "
          "balance, size, {}",
          name, fmt::join(names, ", ")));
    if (!Has(chosen, found->id)) chosen.push_back(*found);
  }
  return chosen;
}

void UseOwnFitness(Measures& measures) {
  for (ReportMeasure& measure : measures)
    if (measure.id == kFitnessMeasure) {
      measure.unit.clear();
      measure.scale = 1;
    }
}

std::optional<ReportMeasure> FindMeasure(std::string_view name) {
  const Measures all = AllMeasures();
  const auto found = FindIn(all, Folded(name));
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::string MeasureName(const ReportMeasure& measure) {
  return Folded(measure.title);
}

}  // namespace plsc
