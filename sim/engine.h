#pragma once

// What moves a robot: the small interface behind World that the physics engines
// have in common, and the state that all of them keep alike. Both solve the
// same equations, contacts and servos of the same options (sim/ode by ODE,
// sim/articulated by the project's own method); what they share, where links
// meet the ground and when a state is no robot's, stands in sim/.
//
// Each room defines its maker; nobody else knows what is in it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/assembly.h"
#include "sim/ground.h"
#include "sim/options.h"
#include "sim/outcome.h"
#include "sim/placement.h"
#include "sim/terrain.h"

namespace plsc {

struct LinkMotion {
  Eigen::Vector3d velocity;  ///< m/s, of the centre of mass
  Eigen::Vector3d spin;      ///< rad/s, world frame
};

/// What a step is made of, in this order.
enum class StepPart : std::uint8_t {
  kCollision,  ///< contacts are found and handed to the solver
  kSolver,     ///< the engine's step
  kChecks,     ///< contacts are dropped, the new state is judged
};

/// What a world begins with.
struct Scene {
  const Assembly& assembly;
  const Terrain& terrain;
  const SimulationOptions& options;
  const Placement& placement;
};

class Engine {
 public:
  struct Failure {
    Outcome outcome = Outcome::kCompleted;
    std::string reason;  ///< in words, of the latest step
  };

  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  virtual void SetJointSpeed(int joint, double speed) = 0;
  virtual void SetMotion(int link, const LinkMotion& motion) = 0;
  virtual void SetState(int link, const LinkPose& pose,
                        const LinkMotion& motion) = 0;
  /// False if the state went wrong; failure tells how.
  [[nodiscard]] virtual bool Step() = 0;
  virtual double JointAngle(int joint) const = 0;
  /// rad/s, by joint: at which the latest step left them turning. One call for
  /// all, as it is asked after every step.
  virtual void TellJointSpeeds(std::vector<double>& speeds) const = 0;
  /// N m, by joint: with which the servos turned them in the latest step.
  virtual void TellJointTorques(std::vector<double>& torques) const = 0;
  virtual LinkPose PoseOf(int link) const = 0;
  virtual LinkMotion MotionOf(int link) const = 0;
  /// Of where all links are and how they move, bit for bit.
  virtual std::uint64_t Hash() const = 0;

  Failure failure;
  std::vector<bool> touched;  ///< by Body::modules, in the latest step
  int contacts = 0;           ///< of the latest step
  int warnings = 0;           ///< steps that the solver did not end, so far
  std::function<void(StepPart)> listener;  ///< may be empty

 protected:
  explicit Engine(const Assembly& assembly)
      : touched(static_cast<std::size_t>(ModulesOf(assembly))) {}
};

/// Of a build that HasOde.
std::unique_ptr<Engine> MakeOdeEngine(const Scene& scene);
std::unique_ptr<Engine> MakeArticulatedEngine(const Scene& scene);

}  // namespace plsc
