#include "runtime/recording/recording_json.h"

#include <nlohmann/json.hpp>

#include "runtime/recording/track.h"
#include "runtime/scenario/scenario_terrain.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

template <typename Vector>
Json ListJson(const Vector& numbers) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < numbers.size(); ++i) list.push_back(numbers(i));
  return list;
}

Json OptionalJson(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json TerrainJson(const Terrain& terrain) {
  Json json;
  json["type"] = NameIn(kTerrainNames, terrain.type);
  // Seeds as text: many readers' numbers end at 2^53.
  switch (terrain.type) {
    case TerrainType::kFlat:
      break;
    case TerrainType::kTilted:
      json["tilt"] = terrain.tilt;
      break;
    case TerrainType::kRough:
      json["seed"] = std::to_string(terrain.rough.seed);
      json["amplitude"] = terrain.rough.amplitude;
      json["wavelength"] = terrain.rough.wavelength;
      break;
    case TerrainType::kSteps:
      json["height"] = terrain.steps.height;
      json["depth"] = terrain.steps.depth;
      json["count"] = terrain.steps.count;
      break;
    case TerrainType::kObstacles:
      json["seed"] = std::to_string(terrain.obstacles.seed);
      json["spacing"] = terrain.obstacles.spacing;
      json["size"] = terrain.obstacles.size;
      json["height"] = terrain.obstacles.height;
      break;
  }
  return json;
}

Json LinkJson(const RecordedLink& link) {
  Json json;
  json["mass"] = link.mass;
  json["rest"] = ListJson(link.rest);
  json["boxes"] = Json::array();
  for (const RecordedBox& box : link.boxes)
    json["boxes"].push_back({{"module", box.module},
                             {"part", NameIn(kPartNames, box.part)},
                             {"size", ListJson(box.size)},
                             {"centre", ListJson(box.centre)},
                             {"turn", ListJson(box.turn)}});
  return json;
}

Json BodyJson(const RecordedBody& body) {
  Json json;
  json["modules"] = Json::array();
  for (const RecordedModule& module : body.modules)
    json["modules"].push_back(
        {{"id", module.id}, {"type", ModuleName(module.type)}});
  json["links"] = Json::array();
  for (const RecordedLink& link : body.links)
    json["links"].push_back(LinkJson(link));
  json["joints"] = Json::array();
  for (const RecordedJoint& joint : body.joints)
    json["joints"].push_back({{"module", joint.module},
                              {"parent", joint.parent},
                              {"child", joint.child},
                              {"anchor", ListJson(joint.anchor)},
                              {"axis", ListJson(joint.axis)}});
  return json;
}

Json TrackJson(const Eigen::MatrixXd& numbers, double unit) {
  return {{"unit", unit},
          {"rows", numbers.rows()},
          {"data", EncodeTrack(numbers, unit)}};
}

Json MotionJson(const Motion& motion) {
  Eigen::MatrixXd steps(motion.samples() > 0 ? 1 : 0, motion.samples());
  for (Eigen::Index i = 0; i < motion.samples(); ++i)
    steps(0, i) =
        static_cast<double>(motion.steps[static_cast<std::size_t>(i)]);
  Json json;
  json["step"] = motion.step;
  json["samples"] = motion.samples();
  json["steps"] = TrackJson(steps, 1);
  json["position"] = TrackJson(motion.position, kPositionUnit);
  json["turn"] = TrackJson(motion.turn, kTurnUnit);
  json["joint_angle"] = TrackJson(motion.joint_angle, kAngleUnit);
  json["touch"] = TrackJson(motion.touch.cast<double>(), 1);
  return json;
}

Json RecordedSeasonJson(const RecordedSeason& season) {
  Json json;
  json["name"] = season.name;
  json["terrain"] = TerrainJson(season.terrain);
  json["begin"] = season.begin;
  json["duration"] = season.duration;
  json["change"] = NameIn(kChangeNames, season.change);
  json["change_reason"] = season.change_reason;
  json["outcome"] = OutcomeName(season.outcome);
  json["reason"] = season.reason;
  json["speed"] = OptionalJson(season.speed);
  json["balance"] = OptionalJson(season.balance);
  json["fitness"] = OptionalJson(season.fitness);
  // Older readers know none.
  for (const Target& target : season.targets)
    json["targets"].push_back({{"x", target.x}, {"y", target.y}});
  json["body"] = BodyJson(season.body);
  json["motion"] = MotionJson(season.motion);
  return json;
}

}  // namespace

std::string RecordingJson(const Recording& recording) {
  Json json;
  json["plsc_recording"] = kRecordingVersion;
  json["name"] = recording.name;
  json["genotype"] = recording.genotype;
  json["scenario"] = recording.scenario;
  json["seasons"] = Json::array();
  for (const RecordedSeason& season : recording.seasons)
    json["seasons"].push_back(RecordedSeasonJson(season));
  return json.dump() + '\n';
}

}  // namespace plsc
