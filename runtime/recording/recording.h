#pragma once

// A life as it can be shown again: what a Life leaves when it was watched,
// reduced to what a picture needs. All that later tools (replays, plots) know
// of a robot; they need neither the language nor ODE. Files of it:
// runtime/recording/recording_json.h.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/enum_names.h"
#include "runtime/life/life.h"
#include "sim/modules.h"
#include "sim/pose_recorder.h"

namespace plsc {

struct RecordedBox {
  int module = 0;  ///< index into RecordedBody::modules
  Part part = Part::kCore;
  Eigen::Vector3d size;    ///< m, full lengths of the sides
  Eigen::Vector3d centre;  ///< m, from the link's centre of mass, at rest
  Eigen::Vector4d turn;    ///< unit quaternion w, x, y, z, at rest
};

/// A rigid part; at rest its axes are the world's.
struct RecordedLink {
  double mass = 0;       ///< kg
  Eigen::Vector3d rest;  ///< m, of its centre of mass from the core's centre
  std::vector<RecordedBox> boxes;
};

struct RecordedJoint {
  int module = 0;          ///< index into RecordedBody::modules
  int parent = 0;          ///< index into RecordedBody::links
  int child = 0;           ///< likewise
  Eigen::Vector3d anchor;  ///< m, from the parent's centre of mass, at rest
  Eigen::Vector3d axis;    ///< unit, at rest
};

struct RecordedModule {
  std::string id;  ///< "1" the core, "2"..., "1s2" a sensor
  ModuleType type = ModuleType::kCore;
};

struct RecordedBody {
  std::vector<RecordedModule> modules;
  std::vector<RecordedLink> links;  ///< the first box of the first: the core
  std::vector<RecordedJoint> joints;
};

struct RecordedSeason {
  std::string name;
  Terrain terrain;
  double begin = 0;     ///< s since birth
  double duration = 0;  ///< s, as announced
  Outcome outcome = Outcome::kCompleted;
  std::string reason;
  Change change = Change::kBorn;  ///< of the robot, at the start
  std::string change_reason;
  std::optional<double> speed;    ///< m/s, the paper's Speed
  std::optional<double> balance;  ///< the paper's Balance
  std::optional<double> fitness;  ///< by default m/s
  std::vector<Target> targets;    ///< of the scenario
  RecordedBody body;              ///< empty if there was none
  Motion motion;                  ///< without samples if not simulated
};

struct Recording {
  std::string name;      ///< of the genotype
  std::string genotype;  ///< its text
  std::string scenario;  ///< YAML, every constant written out
  std::vector<RecordedSeason> seasons;
};

RecordedBody RecordBody(const Body& body);

/// `motion` as the PoseRecorder took it in this season of the scenario.
RecordedSeason RecordSeason(const Scenario& scenario, const Season& season,
                            const SeasonLife& life, Motion motion);

/// m, of the centre of mass of the whole robot, (3 x samples).
Eigen::Matrix3Xd MassCentres(const RecordedSeason& season);

/// "core", "brick", "frame", "servo", "plate", "sensor".
inline constexpr EnumNames<Part, 6> kPartNames{{{Part::kCore, "core"},
                                                {Part::kBrick, "brick"},
                                                {Part::kFrame, "frame"},
                                                {Part::kServo, "servo"},
                                                {Part::kPlate, "plate"},
                                                {Part::kSensor, "sensor"}}};

}  // namespace plsc
