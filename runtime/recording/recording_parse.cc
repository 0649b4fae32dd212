// The reading half of recording_json.h. A recording may come from anywhere, and
// who draws one takes its indices, sizes and turns as they are; so all of them
// are checked here, against each other, too: joints name links that there are,
// tracks have the rows that the body asks for, samples rise in time. Nothing is
// allocated on a number's word (DecodeTrack). Reading goes on after an error
// with what a default is, so that all errors are told at once, and nothing is
// returned if there was one.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "grammar/enum_names.h"
#include "grammar/number.h"
#include "runtime/recording/recording_json.h"
#include "runtime/recording/track.h"
#include "runtime/scenario/scenario_terrain.h"
#include "runtime/text/json_reader.h"
#include "runtime/text/json_text.h"

namespace plsc {

namespace {

constexpr std::int64_t kMaxInt = std::numeric_limits<int>::max();
// A quaternion of a file is rounded to 2^-15 at each part, and no further.
constexpr double kUnitTolerance = 1e-3;

template <int kSize>
Eigen::Matrix<double, kSize, 1> ReadVector(JsonReader& reader,
                                           const JsonValue& object,
                                           std::string_view key) {
  Eigen::Matrix<double, kSize, 1> vector;
  vector.setZero();
  Eigen::Index count = 0;
  reader.List(object, key, [&](const JsonValue& number) {
    if (count < kSize) vector(count) = reader.Number(number);
    ++count;
  });
  if (count != kSize)
    reader.Error(object, Code::kMisfit,
                 fmt::format("expected {} numbers for '{}', found {}", kSize,
                             key, count));
  return vector;
}

template <typename Enum, std::size_t N>
Enum ReadEnum(JsonReader& reader, const JsonValue& object, std::string_view key,
              const EnumNames<Enum, N>& names) {
  const std::string text = reader.Text(object, key);
  if (const std::optional<Enum> value = ValueIn(names, text)) return *value;
  reader.Error(object, Code::kUnknownWord,
               fmt::format("unknown value '{}' for '{}'", text, key));
  return Enum{};
}

int ReadIndex(JsonReader& reader, const JsonValue& object, std::string_view key,
              std::size_t size) {
  return static_cast<int>(
      reader.Integer(object, key, 0, static_cast<std::int64_t>(size) - 1));
}

std::uint64_t ReadSeed(JsonReader& reader, const JsonValue& object) {
  const std::string text = reader.Text(object, "seed");
  const auto seed = ParseNumber<std::uint64_t>(text);
  if (!seed)
    reader.Error(object, Code::kWrongKind,
                 fmt::format("expected a whole number as text for 'seed', "
                             "found '{}'",
                             text));
  return seed.value_or(0);
}

std::span<const std::string_view> TerrainKeys(TerrainType type) {
  static constexpr std::string_view kTilted[] = {"type", "tilt"};
  static constexpr std::string_view kRough[] = {"type", "seed", "amplitude",
                                                "wavelength"};
  static constexpr std::string_view kSteps[] = {"type", "height", "depth",
                                                "count"};
  static constexpr std::string_view kObstacles[] = {"type", "seed", "spacing",
                                                    "size", "height"};
  switch (type) {
    case TerrainType::kFlat:
      return std::span(kTilted).first(1);
    case TerrainType::kTilted:
      return kTilted;
    case TerrainType::kRough:
      return kRough;
    case TerrainType::kSteps:
      return kSteps;
    case TerrainType::kObstacles:
      return kObstacles;
  }
  return {};
}

Terrain ReadTerrainJson(JsonReader& reader, const JsonValue& value) {
  Terrain terrain;
  if (!value.json.is_object()) {
    reader.Wrong(value, "an object");
    return terrain;
  }
  terrain.type = ReadEnum(reader, value, "type", kTerrainNames);
  reader.IsObject(value, TerrainKeys(terrain.type));
  switch (terrain.type) {
    case TerrainType::kFlat:
      break;
    case TerrainType::kTilted:
      terrain.tilt = reader.Number(value, "tilt");
      break;
    case TerrainType::kRough:
      terrain.rough = {ReadSeed(reader, value),
                       reader.Number(value, "amplitude"),
                       reader.Number(value, "wavelength")};
      break;
    case TerrainType::kSteps:
      terrain.steps = {
          reader.Number(value, "height"), reader.Number(value, "depth"),
          static_cast<int>(reader.Integer(value, "count", 1, kMaxInt))};
      break;
    case TerrainType::kObstacles:
      terrain.obstacles = {
          ReadSeed(reader, value), reader.Number(value, "spacing"),
          reader.Number(value, "size"), reader.Number(value, "height")};
      break;
  }
  return terrain;
}

RecordedBox ReadBox(JsonReader& reader, const JsonValue& value,
                    std::size_t modules) {
  static constexpr std::array<std::string_view, 5> kKnown{
      "module", "part", "size", "centre", "turn"};
  RecordedBox box;
  if (!reader.IsObject(value, kKnown)) return box;
  box.module = ReadIndex(reader, value, "module", modules);
  box.part = ReadEnum(reader, value, "part", kPartNames);
  box.size = ReadVector<3>(reader, value, "size");
  box.centre = ReadVector<3>(reader, value, "centre");
  box.turn = ReadVector<4>(reader, value, "turn");
  if ((box.size.array() <= 0).any())
    reader.Error(value, Code::kOutOfRange, "a box has sides of more than 0 m");
  if (std::abs(box.turn.norm() - 1) > kUnitTolerance)
    reader.Error(value, Code::kMisfit,
                 "expected a quaternion of length 1 for "
                 "'turn'");
  return box;
}

RecordedLink ReadLink(JsonReader& reader, const JsonValue& value,
                      std::size_t modules) {
  static constexpr std::array<std::string_view, 3> kKnown{"mass", "rest",
                                                          "boxes"};
  RecordedLink link;
  if (!reader.IsObject(value, kKnown)) return link;
  link.mass = reader.Number(value, "mass");
  if (!(link.mass > 0))
    reader.Error(value, Code::kOutOfRange,
                 "a link has a mass of more than 0 kg");
  link.rest = ReadVector<3>(reader, value, "rest");
  reader.List(value, "boxes", [&](const JsonValue& box) {
    link.boxes.push_back(ReadBox(reader, box, modules));
  });
  if (link.boxes.empty())
    reader.Error(value, Code::kMisfit, "a link has boxes");
  return link;
}

RecordedJoint ReadJoint(JsonReader& reader, const JsonValue& value,
                        const RecordedBody& body) {
  static constexpr std::array<std::string_view, 5> kKnown{
      "module", "parent", "child", "anchor", "axis"};
  RecordedJoint joint;
  if (!reader.IsObject(value, kKnown)) return joint;
  joint.module = ReadIndex(reader, value, "module", body.modules.size());
  joint.parent = ReadIndex(reader, value, "parent", body.links.size());
  joint.child = ReadIndex(reader, value, "child", body.links.size());
  joint.anchor = ReadVector<3>(reader, value, "anchor");
  joint.axis = ReadVector<3>(reader, value, "axis");
  return joint;
}

RecordedBody ReadBody(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 3> kKnown{"modules", "links",
                                                          "joints"};
  static constexpr std::array<std::string_view, 2> kModule{"id", "type"};
  RecordedBody body;
  if (!reader.IsObject(value, kKnown)) return body;
  reader.List(value, "modules", [&](const JsonValue& module) {
    if (!reader.IsObject(module, kModule)) return;
    body.modules.push_back({reader.Text(module, "id"),
                            ReadEnum(reader, module, "type", kModuleNames)});
  });
  reader.List(value, "links", [&](const JsonValue& link) {
    body.links.push_back(ReadLink(reader, link, body.modules.size()));
  });
  reader.List(value, "joints", [&](const JsonValue& joint) {
    body.joints.push_back(ReadJoint(reader, joint, body));
  });
  return body;
}

struct TrackShape {
  std::size_t rows = 0;
  Eigen::Index samples = 0;
  double unit = 1;
};

Eigen::MatrixXd ReadTrack(JsonReader& reader, const JsonValue& motion,
                          std::string_view key, const TrackShape& shape) {
  static constexpr std::array<std::string_view, 3> kKnown{"unit", "rows",
                                                          "data"};
  const auto rows = static_cast<Eigen::Index>(shape.rows);
  Eigen::MatrixXd numbers;
  reader.With(motion, key, [&](const JsonValue& track) {
    if (!reader.IsObject(track, kKnown)) return;
    const double unit = reader.Number(track, "unit");
    if (unit != shape.unit)
      reader.Error(
          track, Code::kUnknownWord,
          fmt::format("expected {} for 'unit', found {}", shape.unit, unit));
    const auto found =
        static_cast<Eigen::Index>(reader.Integer(track, "rows", 0, kMaxInt));
    // Nothing was moving where nothing was simulated.
    if (found != (shape.samples == 0 ? 0 : rows)) {
      reader.Error(track, Code::kMisfit,
                   fmt::format("expected {} rows for '{}', as the body has, "
                               "found {}",
                               rows, key, found));
      return;
    }
    if (auto decoded =
            DecodeTrack(reader.Text(track, "data"), found, shape.samples, unit))
      numbers = std::move(*decoded);
    else
      reader.Error(track, Code::kMisfit,
                   fmt::format("'data' is not {} times {} numbers", found,
                               shape.samples));
  });
  return numbers;
}

void ReadSteps(JsonReader& reader, const JsonValue& value, Eigen::Index samples,
               Motion& motion) {
  const Eigen::MatrixXd steps =
      ReadTrack(reader, value, "steps", {1, samples, 1});
  for (Eigen::Index i = 0; i < steps.size(); ++i) {
    const auto step = static_cast<std::int64_t>(steps(i));
    if (step < 0 || (i > 0 && step <= motion.steps.back())) {
      reader.Error(value, Code::kMisfit, "'steps' do not rise from 0");
      return;
    }
    motion.steps.push_back(step);
  }
}

Motion ReadMotion(JsonReader& reader, const JsonValue& value,
                  const RecordedBody& body) {
  static constexpr std::array<std::string_view, 7> kKnown{
      "step", "samples", "steps", "position", "turn", "joint_angle", "touch"};
  Motion motion;
  if (!reader.IsObject(value, kKnown)) return motion;
  motion.step = reader.Number(value, "step");
  if (!(motion.step > 0))
    reader.Error(value, Code::kOutOfRange, "a 'step' takes more than 0 s");
  const auto samples =
      static_cast<Eigen::Index>(reader.Integer(value, "samples", 0, kMaxInt));
  std::size_t sensors = 0;
  for (const RecordedModule& module : body.modules)
    if (module.type == ModuleType::kTouchSensor) ++sensors;
  const std::size_t links = body.links.size();
  if (samples > 0 && links == 0)
    reader.Error(value, Code::kMisfit, "samples of a robot without links");
  ReadSteps(reader, value, samples, motion);
  motion.position =
      ReadTrack(reader, value, "position", {3 * links, samples, kPositionUnit});
  motion.turn =
      ReadTrack(reader, value, "turn", {4 * links, samples, kTurnUnit});
  motion.joint_angle = ReadTrack(reader, value, "joint_angle",
                                 {body.joints.size(), samples, kAngleUnit});
  const Eigen::MatrixXd touch =
      ReadTrack(reader, value, "touch", {sensors, samples, 1});
  if ((touch.array() < 0).any() || (touch.array() > 1).any())
    reader.Error(value, Code::kOutOfRange, "'touch' is 0 or 1");
  else
    motion.touch = touch.cast<int>();
  for (Eigen::Index i = 0; i < motion.turn.size(); i += 4)
    if (const double norm =
            Eigen::Map<const Eigen::Vector4d>(motion.turn.data() + i).norm();
        std::abs(norm - 1) > kUnitTolerance) {
      reader.Error(value, Code::kMisfit,
                   fmt::format("'turn' has a quaternion of length {}", norm));
      break;
    }
  return motion;
}

Target ReadTarget(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 2> kKnown{"x", "y"};
  if (!reader.IsObject(value, kKnown)) return {};
  return {reader.Number(value, "x"), reader.Number(value, "y")};
}

RecordedSeason ReadSeason(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 14> kKnown{
      "name",    "terrain", "begin", "duration", "change",
      "outcome", "reason",  "speed", "balance",  "change_reason",
      "fitness", "targets", "body",  "motion"};
  RecordedSeason season;
  if (!reader.IsObject(value, kKnown)) return season;
  season.name = reader.Text(value, "name");
  reader.With(value, "terrain", [&](const JsonValue& terrain) {
    season.terrain = ReadTerrainJson(reader, terrain);
  });
  season.begin = reader.Number(value, "begin");
  season.duration = reader.Number(value, "duration");
  season.change = ReadEnum(reader, value, "change", kChangeNames);
  season.change_reason = reader.Text(value, "change_reason");
  season.outcome = ReadEnum(reader, value, "outcome", kOutcomeNames);
  season.reason = reader.Text(value, "reason");
  season.speed = reader.NumberIfAny(value, "speed");
  season.balance = reader.NumberIfAny(value, "balance");
  season.fitness = reader.NumberIfAny(value, "fitness");
  if (reader.Has(value, "targets"))
    reader.List(value, "targets", [&](const JsonValue& target) {
      season.targets.push_back(ReadTarget(reader, target));
    });
  reader.With(value, "body", [&](const JsonValue& body) {
    season.body = ReadBody(reader, body);
  });
  reader.With(value, "motion", [&](const JsonValue& motion) {
    season.motion = ReadMotion(reader, motion, season.body);
    season.motion.begin = season.begin;
  });
  return season;
}

}  // namespace

Result<Recording> ParseRecording(const Source& source) {
  static constexpr std::array<std::string_view, 5> kKnown{
      "plsc_recording", "name", "genotype", "scenario", "seasons"};
  const Result<nlohmann::json> json = ReadJson(source);
  if (!json) return json.diagnostics();
  JsonReader reader(source);
  const JsonValue root{*json, nullptr, ""};
  Recording recording;
  if (!root.json.is_object())
    reader.Wrong(root, "an object");
  else if (reader.IsReadable(root, "plsc_recording", kRecordingVersion,
                             "recording") &&
           reader.IsObject(root, kKnown)) {
    recording.name = reader.Text(root, "name");
    recording.genotype = reader.Text(root, "genotype");
    recording.scenario = reader.Text(root, "scenario");
    reader.List(root, "seasons", [&](const JsonValue& season) {
      recording.seasons.push_back(ReadSeason(reader, season));
    });
  }
  if (!reader.errors().empty()) return reader.errors();
  return recording;
}

}  // namespace plsc
