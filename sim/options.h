#pragma once

// Every constant that a simulation depends on, with its reason. They are
// stored with results: a result is a function of the phenotype, the terrain
// and these. docs/simulation.md tells where the numbers come from.

#include <cstdint>
#include <optional>

namespace plsc {

/// What moves the robots (sim/engine).
enum class EngineKind : std::uint8_t {
  kOde,          ///< what the authors ran: the reference
  kArticulated,  ///< the same equations in joint coordinates (sim/articulated)
};

/// Whether this build has ODE; the articulated engine is in all.
bool HasOde();

/// Of ODE; the articulated engine has one method, which is exact.
enum class Solver : std::uint8_t {
  kDirect,     ///< ODE dWorldStep: Dantzig's method, exact
  kIterative,  ///< ODE dWorldQuickStep: SOR
};

enum class ControllerMode : std::uint8_t {
  /// Oscillators alone, as the authors' program runs them: inputs, weights and
  /// loops are developed but have no effect.
  kOpenLoop,
  /// Touch inputs and loops act on the oscillators:
  /// clamp(O(t) + sum w_i x_i + w_loop (previous - 0.5), 0, 1).
  kCoupled,
};

struct PhysicsOptions {
  double step = 0.005;  ///< s; the authors' flat world
  EngineKind engine = EngineKind::kOde;
  Solver solver = Solver::kDirect;
  int solver_iterations = 50;  ///< kIterative only
  /// Robots of more links are solved iteratively whatever `solver` says: a
  /// direct step grows with the cube of the links (measured: 30 links 1.3 ms,
  /// 60 21 ms, 200 1.7 s, which is 5 hours a life). Robots of 15 modules have
  /// at most 15.
  int max_direct_links = 32;
  double gravity = 9.8;       ///< m/s2, along -z
  double world_erp = 0.1;     ///< joints; the authors' worlds
  double world_cfm = 1e-5;    ///< joints; the authors' worlds
  double friction = 1.0;      ///< mu, both directions of the pyramid
  double slip = 0.01;         ///< m/s per N, both directions
  double robot_kp = 9e4;      ///< N/m, a robot box's contact stiffness
  double robot_kd = 1e7 / 3;  ///< N s/m
  double ground_kp = 2e6;     ///< N/m
  double ground_kd = 9e4;     ///< N s/m
  double damping = 1e-4;      ///< share of velocity lost a step, linear and
                              ///< angular
  /// m/s, at which contacts push bodies apart at most, and m, depth left to
  /// them: the authors' worlds (plane.world, tilted5.world).
  double correcting_speed = 100;
  double surface_layer = 1e-8;
  /// A link beyond these is a solver gone wrong, not a robot. 50 m/s is more
  /// than 50 s of sliding down 5 degrees without friction (42 m/s); joints turn
  /// at 1 rad/s and falls are from decimetres. 500 rad/s moves a point 0.1 m
  /// away as fast.
  double max_speed = 50;  ///< m/s
  double max_spin = 500;  ///< rad/s
  /// Failures of ODE's solver ("LCP internal error") that a life may have, as
  /// a share of its steps. Of 240 lives of random robots none had any; without
  /// slip it is 2 in 100 steps, with joint errors of a few millimetres. At one
  /// in ten the movement is no longer the robot's own.
  double max_solver_failures = 0.1;

  friend bool operator==(const PhysicsOptions&,
                         const PhysicsOptions&) = default;
};

/// When a servo's target is computed anew.
enum class Refresh : std::uint8_t {
  kExact,  ///< at the steps nearest to k / update_rate, the first at birth
  /// At the first step that is more than 1 / update_rate after the one before,
  /// joints braked until the first (authors' program, RobotController.cpp:243:
  /// every 0.130 s at 5 ms, 0.126 s at 3 ms).
  kLate,
};

/// The servo of the joints (authors' program, joint.py:59, Motor.cpp:64): a
/// velocity servo, deliberately weak and slow.
struct ServoOptions {
  double range = 0.7853982;     ///< rad, limits are -range and +range
  double gain = 0.9;            ///< 1/s, target speed per rad of error
  double max_speed = 1.0;       ///< rad/s, clamp of the target speed
  double max_torque = 0.17658;  ///< N m
  double update_rate = 8;       ///< Hz
  Refresh refresh = Refresh::kExact;

  friend bool operator==(const ServoOptions&, const ServoOptions&) = default;
};

/// Of what a robot's inertial measurement unit tells (sim/imu).
struct ImuOptions {
  /// rad; leaning by more is inclined. Midway between the paper's grounds, 0
  /// and 5 degrees. Up to
  /// 10 degrees a core settles to within 1.5 degrees of its ground.
  double threshold = 0.04363323129985824;
  double settling = 1;  ///< s, from being put down to the reading

  friend bool operator==(const ImuOptions&, const ImuOptions&) = default;
};

/// Whose way the speeds tell (sim/measures).
enum class MeasuredPoint : std::uint8_t {
  kMassCentre,  ///< of the whole robot (paper, "Behavioral descriptors")
  kCore,  ///< the core's centre (authors' program, WorldController.cpp:153)
};

struct SimulationOptions {
  double duration = 50;          ///< s
  double sample_interval = 0.2;  ///< s, of the trajectory
  /// m, of the core's centre above the ground, not aligned with it; nothing:
  /// the robot rests on the ground, aligned with it.
  std::optional<double> start_height = 0.03;
  /// m, of a resting robot's lowest point above the ground. More than rounding
  /// by far, less than the first step's fall (0.245 mm): it lands at once and
  /// hardly sinks in.
  double start_clearance = 1e-4;
  ControllerMode controller = ControllerMode::kOpenLoop;
  /// What asks for more is not simulated. A million steps are 83 minutes of
  /// life and half a minute of computing.
  std::int64_t max_steps = 1000000;
  /// Likewise: at 250 links a robot is simulated about as fast as it lives
  /// (4 ms a step; 500 take 10 ms). The paper's robots have 15 at most.
  int max_links = 256;
  PhysicsOptions physics;
  ServoOptions servo;
};

}  // namespace plsc
