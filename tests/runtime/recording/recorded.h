#pragma once

// Small recordings, for tests of what reads and draws them.

#include "runtime/life/life.h"
#include "runtime/recording/recording.h"
#include "sim/simulate.h"
#include "tests/sim/bodies.h"

namespace plsc::test {

/// A core, a joint with a brick before it, a touch sensor at its left.
inline Phenotype SmallRobot() {
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  Mount(body, 0, Slot::kLeft, ModuleType::kTouchSensor);
  return WithOscillators(body, 1, 2);
}

/// The season as lived for `duration` s by the robot.
inline RecordedSeason LiveRecorded(const Phenotype& robot, Season season,
                                   double duration) {
  season.duration = duration;
  SimulationOptions options;
  options.duration = duration;
  options.start_height.reset();
  PoseRecorder recorder;
  SeasonLife life;
  life.trajectory =
      Live(robot, season.terrain, options, {}, &recorder).trajectory;
  life.robot = robot;
  life.result.season = season.name;
  life.result.outcome = life.trajectory.outcome;
  life.result.reason = life.trajectory.reason;
  life.result.behaviour =
      Measure(life.trajectory, 3, MeasuredPoint::kMassCentre);
  Scenario scenario;
  scenario.targets = {{1, -2.5}};
  return RecordSeason(scenario, season, life, recorder.Take());
}

/// Two seasons: flat, and a slope of 5 degrees.
inline Recording SmallRecording() {
  Season flat;
  flat.name = "flat";
  Season slope;
  slope.name = "slope";
  slope.terrain.type = TerrainType::kTilted;
  slope.terrain.tilt = 0.0873;
  return {"small",
          "plsc 1\n",
          "plsc_scenario: 1\n",
          {LiveRecorded(SmallRobot(), flat, 1),
           LiveRecorded(SmallRobot(), slope, 0.5)}};
}

}  // namespace plsc::test
