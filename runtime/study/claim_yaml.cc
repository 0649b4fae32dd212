// The key of a claim's kind says what is compared, "greater: [plastic,
// baseline]", and the key beside it what stays the same: with "season" the two
// are experiments, with "experiment" they are seasons. So no claim can name a
// pair of both, and the reader never guesses what a name is of.

#include "runtime/study/claim_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "grammar/number.h"
#include "grammar/suggest.h"
#include "runtime/study/report_measures.h"
#include "runtime/study/study_experiment.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

namespace {

// More is a slip of the pen: each is a line that a reader of a report reads.
constexpr std::size_t kMaxClaims = 1000;
constexpr std::size_t kMaxText = 2000;  // bytes of a name or a source

const StudyExperiment* Find(const std::vector<StudyExperiment>& experiments,
                            std::string_view name) {
  for (const StudyExperiment& one : experiments)
    if (one.name == name) return &one;
  return nullptr;
}

std::vector<std::string_view> SeasonNames(const StudyExperiment& experiment) {
  std::vector<std::string_view> names;
  for (const Season& season : experiment.experiment.scenario.seasons)
    names.push_back(season.name);
  return names;
}

bool Has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string NoSeason(const StudyExperiment& experiment,
                     std::string_view season) {
  return fmt::format("experiment '{}' has no season '{}'", experiment.name,
                     season);
}

std::string TooFewGenerations(const StudyExperiment& experiment) {
  return fmt::format("experiment '{}' has {} generations, 0 to {}",
                     experiment.name, experiment.experiment.generations,
                     experiment.experiment.generations - 1);
}

bool IsBeyond(const StudyExperiment& experiment, int minimum_before) {
  return minimum_before >= experiment.experiment.generations;
}

/// Says what is unknown, and what was meant or there is.
void ReportUnknown(const YamlValue& at, const std::string& message,
                   const std::vector<std::string_view>& known) {
  const auto nearest = Suggest(at.text(), known);
  at.Report(Code::kUnknownWord, message,
            nearest
                ? fmt::format("did you mean '{}'?", *nearest)
                : fmt::format("there {} {}", known.size() == 1 ? "is" : "are",
                              fmt::join(known, ", ")),
            nearest.value_or(""));
}

/// One claim, key by key.
class ClaimReader {
 public:
  ClaimReader(const std::vector<StudyExperiment>& experiments, ClaimCheck check)
      : experiments_(experiments), check_(check) {}

  Claim Read(const YamlMap::Entry& entry, YamlMap map) {
    claim_.name = entry.key;
    measure_at_ = map.Need("measure", "as in 'measure: speed'");
    ReadMeasure();
    claim_.of = map.Choice("of", ClaimOf::kMean, kClaimOfNames);
    season_ = map.Find("season");
    experiment_ = map.Find("experiment");
    ReadKind(entry, map);
    const auto over_runs = map.Find("over_runs");
    if (over_runs)
      claim_.over_runs =
          over_runs->Choice(kOverRunsNames).value_or(OverRuns::kMedian);
    if (over_runs && kind_ && claim_.kind != ClaimKind::kValue)
      over_runs->Report(Code::kMisfit, "'over_runs' is for claims of a value");
    claim_.family = ReadText(map, "family");
    claim_.source = ReadText(map, "source");
    map.Close();
    return std::move(claim_);
  }

 private:
  static std::string ReadText(YamlMap& map, std::string_view key) {
    const auto value = map.Find(key);
    if (!value) return "";
    std::string text = value->Text("a text").value_or("");
    if (text.size() > kMaxText)
      value->Report(Code::kOutOfRange,
                    fmt::format("expected at most {} bytes", kMaxText));
    return text;
  }

  void ReadMeasure() {
    if (!measure_at_) return;
    const auto name = measure_at_->Text("a measure");
    if (!name) return;
    measure_ = FindMeasure(*name);
    if (measure_) {
      claim_.measure = MeasureName(*measure_);
      return;
    }
    std::vector<std::string> names;
    for (const ReportMeasure& one : AllMeasures())
      names.push_back(MeasureName(one));
    ReportUnknown(*measure_at_, fmt::format("unknown measure '{}'", *name),
                  {names.begin(), names.end()});
  }

  void ReadKind(const YamlMap::Entry& entry, YamlMap& map) {
    for (const auto& [kind, name] : kClaimKindNames) {
      const auto value = map.Find(name);
      if (!value) continue;
      if (kind_) {
        value->Report(Code::kMisfit,
                      fmt::format("a claim has one of '{}' and '{}', not both",
                                  NameIn(kClaimKindNames, claim_.kind), name),
                      "make two claims of it");
        continue;
      }
      kind_ = value;
      claim_.kind = kind;
    }
    if (!kind_)
      entry.at.Report(Code::kMissingKey,
                      "expected one of 'greater', 'less', 'equal', 'value', "
                      "'minimum_before'",
                      "as in 'greater: [plastic, baseline]'");
    else if (IsOfTwo(claim_.kind))
      ReadTwo(entry);
    else
      ReadOne(entry);
  }

  /// Of what is compared, and what stays the same.
  void ReadTwo(const YamlMap::Entry& entry) {
    if (season_.has_value() == experiment_.has_value()) {
      entry.at.Report(
          season_ ? Code::kMisfit : Code::kMissingKey,
          "expected 'season', to compare two experiments in it, or "
          "'experiment', to compare two of its seasons",
          season_ ? "leave one of them out" : "as in 'season: flat'");
      return;
    }
    const std::vector<YamlValue> pair =
        ReadPair(season_ ? "experiments" : "seasons");
    const std::vector<YamlValue> same = {season_ ? *season_ : *experiment_};
    if (pair.empty()) return;
    Place(season_ ? pair : same, season_ ? same : pair);
  }

  void ReadOne(const YamlMap::Entry& entry) {
    if (!season_ || !experiment_) {
      entry.at.Report(
          Code::kMissingKey,
          fmt::format("expected '{}'", season_ ? "experiment" : "season"),
          fmt::format("a claim of '{}' is about an experiment in a season",
                      NameIn(kClaimKindNames, claim_.kind)));
      return;
    }
    Place({*experiment_}, {*season_});
    if (claim_.kind == ClaimKind::kValue)
      ReadValue();
    else
      ReadMinimum();
  }

  std::vector<YamlValue> ReadPair(const char* of) {
    if (kind_->is_scalar() || kind_->is_map() || kind_->CountEntries() != 2) {
      kind_->Report(
          Code::kWrongKind, fmt::format("expected a list of two {}", of),
          season_ ? "as in '[plastic, baseline]'" : "as in '[flat, tilted]'");
      return {};
    }
    std::vector<YamlValue> pair =
        kind_->List(of).value_or(std::vector<YamlValue>());
    if (pair.size() == 2 && pair[0].is_scalar() && pair[1].is_scalar() &&
        pair[0].text() == pair[1].text()) {
      pair[1].Report(Code::kMisfit, fmt::format("'{}' is compared with itself",
                                                pair[1].text()));
      return {};
    }
    return pair;
  }

  /// Names that are read, and looked for.
  void Place(const std::vector<YamlValue>& experiments,
             const std::vector<YamlValue>& seasons) {
    std::vector<std::string_view> known;
    for (const StudyExperiment& one : experiments_) known.push_back(one.name);
    std::vector<const StudyExperiment*> found;
    for (const YamlValue& at : experiments) {
      const auto name = at.Text("an experiment's name");
      if (!name) continue;
      claim_.experiments.push_back(*name);
      if (check_ == ClaimCheck::kWords) continue;
      if (const StudyExperiment* one = Find(experiments_, *name))
        found.push_back(one);
      else
        ReportUnknown(
            at, fmt::format("the study has no experiment '{}'", *name), known);
    }
    for (const YamlValue& at : seasons) {
      const auto name = at.Text("a season's name");
      if (!name) continue;
      claim_.seasons.push_back(*name);
      LookFor(at, *name, found);
    }
    subject_ = found.empty() ? nullptr : found.front();
  }

  void LookFor(const YamlValue& at, const std::string& season,
               const std::vector<const StudyExperiment*>& experiments) const {
    for (const StudyExperiment* one : experiments) {
      // One in a file of its own is not read yet (CheckClaims).
      if (!one->experiment.scenario_file.empty()) continue;
      const std::vector<std::string_view> known = SeasonNames(*one);
      if (Has(known, season)) continue;
      ReportUnknown(at, NoSeason(*one, season), known);
      return;
    }
  }

  /// "3.63 cm/s"
  void ReadValue() {
    if (!measure_) return;  // told
    const std::string& unit = measure_->unit;
    const auto written = kind_->Text("a number");
    if (!written) return;
    std::string_view number = *written;
    bool has_unit = unit.empty();
    if (!unit.empty() && number.ends_with(" " + unit)) {
      number.remove_suffix(unit.size() + 1);
      has_unit = true;
    }
    const auto value = ParseNumber<double>(number);
    if (value && has_unit && !kind_->is_quoted()) {
      claim_.value = *value;
      return;
    }
    const std::string example =
        fmt::format("{}{}{}", value ? PrintPlainNumber(*value) : "3.63",
                    unit.empty() ? "" : " ", unit);
    kind_->Report(
        value ? Code::kWrongUnit : Code::kWrongKind,
        fmt::format("expected a number{}{}, found '{}'",
                    unit.empty() ? "" : " with its unit, ", unit, *written),
        fmt::format("write it as in '{}'", example), value ? example : "");
  }

  void ReadMinimum() {
    // Before generation 1 there is only the one that nothing has fallen to.
    constexpr int kLeast = 2;
    const auto value = kind_->Integer(kLeast, 1'000'000'000, 25);
    if (!value) return;
    claim_.minimum_before = static_cast<int>(*value);
    if (subject_ != nullptr && IsBeyond(*subject_, claim_.minimum_before))
      kind_->Report(Code::kMisfit, TooFewGenerations(*subject_),
                    "name one of them");
  }

  const std::vector<StudyExperiment>& experiments_;
  ClaimCheck check_;
  Claim claim_;
  std::optional<ReportMeasure> measure_;
  std::optional<YamlValue> measure_at_, season_, experiment_;
  std::optional<YamlValue> kind_;  // what the key of its kind has
  const StudyExperiment* subject_ = nullptr;
};

/// The earlier one that is the same but for its words.
const Claim* TwinOf(const Claim& claim, const std::vector<Claim>& earlier) {
  for (const Claim& one : earlier) {
    Claim twin = one;
    twin.name = claim.name;
    twin.source = claim.source;
    if (twin == claim) return &one;
  }
  return nullptr;
}

}  // namespace

std::vector<Claim> ReadClaims(const YamlValue& value,
                              const std::vector<StudyExperiment>& experiments,
                              ClaimCheck check) {
  std::vector<Claim> claims;
  if (value.is_map() && value.CountEntries() > kMaxClaims) {
    value.Report(Code::kMisfit,
                 fmt::format("a study has at most {} claims, found {}",
                             kMaxClaims, value.CountEntries()));
    return claims;
  }
  std::optional<YamlMap> map = value.Map("a map from what is claimed to keys");
  if (!map) return claims;
  for (const YamlMap::Entry& entry : map->TakeAll()) {
    if (value.is_full()) break;
    if (entry.key.empty() || entry.key.size() > kMaxText)
      entry.at.Report(
          Code::kOutOfRange,
          fmt::format("expected what is claimed, in 1 to {} bytes", kMaxText));
    std::optional<YamlMap> keys = entry.value.Map("keys of a claim");
    if (!keys) continue;
    const std::size_t errors = value.error_count();
    Claim claim = ClaimReader(experiments, check).Read(entry, std::move(*keys));
    const Claim* twin =
        value.error_count() > errors ? nullptr : TwinOf(claim, claims);
    if (twin != nullptr)
      entry.at.Report(Code::kMisfit,
                      fmt::format("this claims what '{}' does", twin->name),
                      "leave one of them out");
    claims.push_back(std::move(claim));
  }
  if (map->TakeAll().empty())
    value.Report(Code::kMisfit, "expected at least one claim",
                 "leave 'claims' out if there is none");
  return claims;
}

std::vector<Diagnostic> CheckClaims(
    const std::vector<Claim>& claims,
    const std::vector<StudyExperiment>& experiments) {
  std::vector<Diagnostic> problems;
  const auto report = [&](const Claim& claim, const std::string& message) {
    problems.emplace_back(Code::kMisfit, Span{},
                          fmt::format("claim '{}': {}", claim.name, message));
  };
  const auto is_fitness = [](const Claim& claim) {
    const std::optional<ReportMeasure> measure = FindMeasure(claim.measure);
    return measure && measure->id == kFitnessMeasure;
  };
  for (const Claim& claim : claims)
    for (const std::string& name : claim.experiments) {
      const StudyExperiment* one = Find(experiments, name);
      if (one == nullptr) continue;  // told by ReadClaims
      for (const std::string& season : claim.seasons)
        if (!Has(SeasonNames(*one), season))
          report(claim, NoSeason(*one, season));
      if (claim.kind == ClaimKind::kMinimumBefore &&
          IsBeyond(*one, claim.minimum_before))
        report(claim, TooFewGenerations(*one));
      // Its number would be compared with one of another unit.
      if (claim.kind == ClaimKind::kValue && is_fitness(claim) &&
          HasOwnFitness(one->experiment))
        report(claim, fmt::format("the fitness of experiment '{}' is a formula "
                                  "of its own and no speed in cm/s: claim a "
                                  "value of what it is made of",
                                  name));
    }
  return problems;
}

}  // namespace plsc
