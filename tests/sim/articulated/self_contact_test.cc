// Which pairs of links a collider looks at, against one that looks at all of
// them in every step.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/articulated/collider.h"
#include "tests/sanitizer.h"
#include "tests/sim/articulated/driven.h"

namespace plsc::articulated {
namespace {

/// The state of a robot, as its engine tells it.
class Shown {
 public:
  explicit Shown(const test::Driven& robot)
      : model_(robot.assembly), ground_(GroundAxes(robot.terrain)) {
    state.links.resize(robot.assembly.links.size());
  }

  /// rad: the most that a joint has turned since the last look.
  double Look(const test::Driven& robot) {
    std::vector<Eigen::Matrix3d> axes;
    axes.reserve(state.links.size());
    for (int link = 0; link < robot.links(); ++link)
      axes.push_back(ground_.transpose() * robot.engine.PoseOf(link).axes);
    std::vector<double> before;
    before.reserve(state.links.size());
    for (const LinkState& link : state.links) before.push_back(link.angle);
    Fit(model_, axes, state);
    Place(model_, state);
    state.base = ground_.transpose() * robot.engine.PoseOf(0).position;
    double most = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      most = std::max(most, std::abs(state.links[i].angle - before[i]));
    return most;
  }

  const Model& model() const { return model_; }
  State state;

 private:
  Model model_;
  Eigen::Matrix3d ground_;
};

bool AreSame(const Contact& a, const Contact& b) {
  return a.key == b.key && a.link == b.link && a.other == b.other &&
         a.point == b.point && a.depth == b.depth &&
         a.directions == b.directions;
}

struct Seen {
  int steps = 0;
  int meeting = 0;  ///< steps in which links met
  int changes = 0;  ///< steps at which that began or ended
};

/// Both colliders through a life: what they find must be the same.
Seen Live(const Phenotype& phenotype, const Terrain& terrain, int steps) {
  test::Driven robot(phenotype.body, terrain, test::Articulated());
  Shown shown(robot);
  const Placement start = StartOf(robot.assembly, terrain, robot.options, {});
  const Scene scene{robot.assembly, terrain, robot.options, start};
  Collider quick(scene, shown.model()), thorough(scene, shown.model());
  const auto modules = static_cast<std::size_t>(ModulesOf(robot.assembly));
  Seen seen;
  bool met = false;
  while (robot.steps < steps) {
    const double turned = shown.Look(robot);
    std::vector<bool> touched(modules), touched_in_truth(modules);
    const auto& found = quick.Find(shown.state, turned, touched);
    thorough.Forget();
    const auto& in_truth = thorough.Find(shown.state, 0, touched_in_truth);
    if (!std::equal(found.begin(), found.end(), in_truth.begin(),
                    in_truth.end(), AreSame) ||
        touched != touched_in_truth)
      FAIL("contacts differ in step " << robot.steps);
    const auto self = std::count_if(
        in_truth.begin(), in_truth.end(),
        [](const Contact& contact) { return contact.other != kGround; });
    // Servos that drive joints into stops for long may fling a module away.
    if (!robot.Step()) break;
    // The engine's own, too.
    if (robot.engine.report().self_contacts != self)
      FAIL("the engine misses a contact in step " << robot.steps);
    ++seen.steps;
    if (self > 0) ++seen.meeting;
    if ((self > 0) != met) ++seen.changes;
    met = self > 0;
  }
  return seen;
}

bool MeetsItself(const Phenotype& phenotype) {
  test::Driven robot(phenotype.body, {}, test::Articulated());
  while (robot.steps < 600) {
    if (!robot.Step()) FAIL(robot.engine.failure.reason);
    if (robot.engine.report().self_contacts > 0) return true;
  }
  return false;
}

/// Lives of as many robots that fold up until links meet.
void CheckLives(int robots, int steps) {
  std::mt19937 random(9);  // any
  Seen all;
  for (int i = 0; i < robots; ++i) {
    CAPTURE(i);
    Phenotype robot;
    do robot = RandomRobot(10 + i % 8, random);
    while (!MeetsItself(robot));
    const Terrain grounds[] = {
        {}, test::Slope(5), test::RoughGround(1, 0.02, 0.2)};
    const Seen seen = Live(robot, grounds[i % 3], steps);
    all.steps += seen.steps;
    all.meeting += seen.meeting;
    all.changes += seen.changes;
  }
  // Else too little was compared.
  CAPTURE(all.steps, all.meeting, all.changes);
  CHECK(20 * all.meeting > all.steps);
  CHECK(all.changes >= robots);
}

TEST_CASE("No pair of links that meets is left out", "[self_contact]") {
  CheckLives(PLSC_HAS_ASAN ? 3 : 10, 700);
}

TEST_CASE("No pair of links that meets is left out of long lives",
          "[self_contact][slow]") {
  CheckLives(24, 3000);
}

}  // namespace
}  // namespace plsc::articulated
