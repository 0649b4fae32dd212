#include "runtime/recording/recording.h"

#include <Eigen/Geometry>
#include <cassert>
#include <utility>

#include "sim/assembly.h"

namespace plsc {

namespace {

RecordedLink RecordLink(const Link& link) {
  RecordedLink recorded;
  recorded.mass = link.mass;
  recorded.rest = link.centre;
  for (const Box& box : link.boxes) {
    const Eigen::Quaterniond turn(box.axes);
    recorded.boxes.push_back({box.module,
                              box.part,
                              box.size,
                              box.centre - link.centre,
                              {turn.w(), turn.x(), turn.y(), turn.z()}});
  }
  return recorded;
}

}  // namespace

RecordedBody RecordBody(const Body& body) {
  RecordedBody recorded;
  for (std::size_t i = 0; i < body.modules.size(); ++i)
    recorded.modules.push_back(
        {ModuleId(body, static_cast<int>(i)), body.modules[i].type});
  const Assembly assembly = Assemble(body);
  for (const Link& link : assembly.links)
    recorded.links.push_back(RecordLink(link));
  for (const Hinge& hinge : assembly.hinges)
    recorded.joints.push_back(
        {hinge.module, hinge.parent, hinge.child,
         hinge.anchor -
             assembly.links[static_cast<std::size_t>(hinge.parent)].centre,
         hinge.axis});
  return recorded;
}

RecordedSeason RecordSeason(const Scenario& scenario, const Season& season,
                            const SeasonLife& life, Motion motion) {
  const SeasonResult& result = life.result;
  RecordedSeason recorded;
  recorded.name = season.name;
  recorded.terrain = season.terrain;
  recorded.begin = result.begin;
  recorded.duration = season.duration;
  recorded.outcome = result.outcome;
  recorded.reason = result.reason;
  recorded.change = result.change;
  recorded.change_reason = result.change_reason;
  recorded.fitness = result.fitness;
  recorded.targets = scenario.targets;
  if (result.behaviour.is_valid) {
    recorded.speed = result.behaviour.displacement_velocity_hill;
    recorded.balance = result.behaviour.head_balance;
  }
  if (life.robot) recorded.body = RecordBody(life.robot->body);
  recorded.motion = std::move(motion);
  return recorded;
}

Eigen::Matrix3Xd MassCentres(const RecordedSeason& season) {
  const Eigen::Index samples = season.motion.samples();
  Eigen::Matrix3Xd centres = Eigen::Matrix3Xd::Zero(3, samples);
  double mass = 0;
  for (std::size_t i = 0; i < season.body.links.size() && samples > 0; ++i) {
    const double part = season.body.links[i].mass;
    mass += part;
    centres += part * season.motion.position.middleRows<3>(
                          3 * static_cast<Eigen::Index>(i));
  }
  return samples > 0 ? Eigen::Matrix3Xd(centres / mass) : centres;
}

}  // namespace plsc
