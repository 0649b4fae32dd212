// Means over each generation's population, of which a robot survives many: to
// join tables generation by generation would read each robot again and again.
// Every table is read once, in its own order, into flat arrays of the measured
// columns, keys become places in them, and a generation is a list of places. A
// run of the paper, 20,000 robots with all 37 measures, takes a tenth of a
// second (report_bench).
//
// Numbers of a damaged store are not trusted: what does not fit is left out,
// and infinities count as missing, as one would make a mean of all.

#include "runtime/report/population.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "runtime/store/names.h"
#include "runtime/text/key.h"

namespace plsc {

namespace {

using Measures = std::vector<ReportMeasure>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

struct KeyHash {
  // Keys are hashes already.
  std::size_t operator()(const Key& key) const { return key.low; }
};
using Places = std::unordered_map<Key, std::size_t, KeyHash>;

std::size_t Find(const Places& places, const Key& key) {
  const auto found = places.find(key);
  return found == places.end() ? kNowhere : found->second;
}

/// The zero key, which no row has, for what is none.
Key TakeKey(Statement& row) {
  return KeyOfHex(row.TakeText()).value_or(Key{});
}

/// The columns of the measures that are in one table, ", "-led.
std::string ColumnsOf(const Measures& measures, MeasureSource source) {
  std::string text;
  for (const ReportMeasure& measure : measures)
    if (measure.source == source) text += ", " + measure.id;
  return text;
}

/// Rows of a table by key, only the columns that are measured.
struct Rows {
  Places places;               ///< of a row's first value in `values`
  std::vector<double> values;  ///< row after row
};

void TakeValues(Statement& row, int columns, Rows& rows) {
  for (int i = 0; i < columns; ++i) {
    const double value = row.TakeReal();
    // SQLite keeps infinities; sums do not survive them.
    rows.values.push_back(std::isfinite(value) ? value : kNone);
  }
}

Rows ReadRows(Database& database, const std::string& table,
              const Measures& measures, MeasureSource source) {
  Rows rows;
  const std::string columns = ColumnsOf(measures, source);
  if (columns.empty()) return rows;
  Statement row(database, fmt::format("SELECT key{} FROM {}", columns, table));
  row.With();
  while (row.Next()) {
    rows.places.emplace(TakeKey(row), rows.values.size());
    TakeValues(row, row.columns() - 1, rows);
  }
  return rows;
}

/// A body with a brain.
struct Robot {
  std::size_t body_values = kNowhere;
  std::size_t brain_values = kNowhere;
};

/// A robot in a season, as places in what was read.
struct Lived {
  std::size_t robot = kNowhere;
  std::size_t behaviour = kNowhere;
  double fitness = kNone;
};

/// Everything of a run that its means are made of.
class Reading {
 public:
  Reading(Database& database, const Measures& measures)
      : measures_(measures),
        bodies_(ReadRows(database, "body", measures, MeasureSource::kBody)),
        behaviours_(ReadRows(database, "simulation", measures,
                             MeasureSource::kBehaviour)) {
    ReadSeasons(database);
    ReadMembers(database);
    ReadRobots(database);
    ReadEvaluations(database);
    NumberColumns();
  }

  /// Series of the first `shown` measures; those of the servos are behind.
  PopulationSummary Summarise(std::size_t shown, bool with_spread) const {
    PopulationSummary summary;
    summary.seasons = seasons_;
    summary.generations = static_cast<int>(members_.size());
    summary.survivors = survivors_;
    for (std::size_t measure = 0; measure < shown; ++measure)
      for (std::size_t season = 0; season < seasons_.size(); ++season)
        summary.series.push_back(SeriesOf(measure, season, with_spread));
    for (std::size_t season = 0; !members_.empty() && season < seasons_.size();
         ++season)
      summary.errors.push_back(ErrorsOf(shown, shown + 1, season));
    return summary;
  }

 private:
  void ReadSeasons(Database& database) {
    Statement row(database, "SELECT name FROM season ORDER BY id");
    row.With();
    while (row.Next()) seasons_.push_back(row.TakeText());
  }

  // Those that survived at least once.
  void ReadMembers(Database& database) {
    Statement count(database, "SELECT count(*) FROM generation");
    if (count.With().Next())
      members_.resize(static_cast<std::size_t>(count.TakeInt()));
    count.Run();
    Statement row(database,
                  "SELECT generation, individual FROM member "
                  "WHERE survivor IS NOT NULL ORDER BY generation, survivor");
    row.With();
    while (row.Next()) {
      const std::int64_t generation = row.TakeInteger();
      const int id = row.TakeInt();
      if (!std::in_range<std::size_t>(generation) ||
          static_cast<std::size_t>(generation) >= members_.size())
        continue;
      const auto place = lives_.emplace(id, lives_.size()).first->second;
      members_[static_cast<std::size_t>(generation)].push_back(place);
      if (static_cast<std::size_t>(generation) + 1 == members_.size())
        survivors_.push_back(id);
    }
    ReadBest(database);
    lived_.resize(lives_.size() * seasons_.size());
  }

  // The best of a pool need not have survived: tournaments are drawn.
  void ReadBest(Database& database) {
    best_.resize(members_.size(), kNowhere);
    Statement row(database, "SELECT number, best FROM generation");
    row.With();
    while (row.Next()) {
      const std::int64_t generation = row.TakeInteger();
      const int id = row.TakeInt();
      if (std::in_range<std::size_t>(generation) &&
          static_cast<std::size_t>(generation) < best_.size())
        best_[static_cast<std::size_t>(generation)] =
            lives_.emplace(id, lives_.size()).first->second;
    }
  }

  void ReadRobots(Database& database) {
    Statement row(database,
                  fmt::format("SELECT key, body{} FROM phenotype",
                              ColumnsOf(measures_, MeasureSource::kBrain)));
    row.With();
    while (row.Next()) {
      Robot robot;
      const Key key = TakeKey(row);
      robot.body_values = Find(bodies_.places, TakeKey(row));
      robot.brain_values = brains_.values.size();
      TakeValues(row, row.columns() - 2, brains_);
      places_.emplace(key, robots_.size());
      robots_.push_back(robot);
    }
  }

  void ReadEvaluations(Database& database) {
    Statement row(database,
                  "SELECT individual, season, phenotype, simulation, fitness "
                  "FROM evaluation");
    row.With();
    while (row.Next()) {
      const auto life = lives_.find(row.TakeInt());
      const std::int64_t season = row.TakeInteger();  // from 1
      if (life == lives_.end() || season < 1 ||
          season > static_cast<std::int64_t>(seasons_.size()))
        continue;
      Lived& lived = lived_[life->second * seasons_.size() +
                            static_cast<std::size_t>(season - 1)];
      lived.robot = Find(places_, TakeKey(row));
      lived.behaviour = Find(behaviours_.places, TakeKey(row));
      lived.fitness = row.TakeReal();
    }
  }

  // Where in its table's row each measure is.
  void NumberColumns() {
    std::unordered_map<int, std::size_t> counts;
    for (const ReportMeasure& measure : measures_)
      columns_.push_back(counts[static_cast<int>(measure.source)]++);
  }

  double ValueOf(std::size_t measure, const Lived& lived) const {
    const auto at = [&](const Rows& rows, std::size_t row) {
      return row == kNowhere ? kNone : rows.values[row + columns_[measure]];
    };
    const Robot* robot =
        lived.robot == kNowhere ? nullptr : &robots_[lived.robot];
    switch (measures_[measure].source) {
      case MeasureSource::kBehaviour:
        return at(behaviours_, lived.behaviour);
      case MeasureSource::kBody:
        return robot == nullptr ? kNone : at(bodies_, robot->body_values);
      case MeasureSource::kBrain:
        return robot == nullptr ? kNone : at(brains_, robot->brain_values);
      case MeasureSource::kEvaluation:
        return lived.fitness;
    }
    return kNone;
  }

  Series SeriesOf(std::size_t measure, std::size_t season,
                  bool with_spread) const {
    Series series;
    const double scale = measures_[measure].scale;
    const auto value_of = [&](std::size_t life) {
      return scale * ValueOf(measure, lived_[life * seasons_.size() + season]);
    };
    for (const std::size_t life : best_)
      series.best.push_back(life == kNowhere ? kNone : value_of(life));
    std::vector<double> values;
    for (const std::vector<std::size_t>& members : members_) {
      values.clear();
      double sum = 0;
      for (const std::size_t life : members) {
        const double value = value_of(life);
        if (std::isnan(value)) continue;
        values.push_back(value);
        sum += value;
      }
      series.means.push_back(
          values.empty() ? kNone : sum / static_cast<double>(values.size()));
      if (with_spread) series.spreads.push_back(QuartilesOf(values));
    }
    return series;
  }

  /// Of the last generation; `median` and `worst` are places of measures.
  SeasonErrors ErrorsOf(std::size_t median, std::size_t worst,
                        std::size_t season) const {
    std::vector<double> medians;
    double most = kNone;
    for (const std::size_t life : members_.back()) {
      const Lived& lived = lived_[life * seasons_.size() + season];
      const double value = ValueOf(median, lived);
      if (!std::isnan(value)) medians.push_back(value);
      most = std::fmax(most, ValueOf(worst, lived));
    }
    return {QuartilesOf(std::move(medians)).median, most};
  }

  const Measures& measures_;
  std::vector<std::string> seasons_;
  Rows bodies_;
  Rows behaviours_;
  Rows brains_;  // in the order of robots_, without places
  std::vector<Robot> robots_;
  Places places_;                                  // in robots_
  std::unordered_map<int, std::size_t> lives_;     // from ids
  std::vector<Lived> lived_;                       // a life's seasons together
  std::vector<std::vector<std::size_t>> members_;  // lives, by generation
  std::vector<std::size_t> best_;                  // lives, by generation
  std::vector<int> survivors_;                     // of the last generation
  std::vector<std::size_t> columns_;               // by measure
};

}  // namespace

PopulationSummary SummarisePopulation(Database& database,
                                      const Measures& measures,
                                      bool with_spread) {
  Measures all = measures;
  for (const char* column : {"servo_error_median", "servo_error_worst"})
    all.push_back({column, "", "", 1, MeasureSource::kBehaviour});
  return Reading(database, all).Summarise(measures.size(), with_spread);
}

}  // namespace plsc
