// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "dynamics/tree_state.hpp"
#include "robot/model/robot.hpp"
#include "simulation/contact/ground_profile.hpp"

namespace torquewright::hopper {

/// How a step of an engine ended.
enum class EngineOutcome {
  kStepped,
  kUnreached,  ///< A mechanism does not reach the posture.
  kUnsolved,   ///< The contacts' laws could not be met.
  kBlownUp,    ///< A number is not finite, or grew without bound.
};

struct EngineOptions {
  double ground_height_m = 0.0;
  simulation::GroundProfile profile = {};  ///< Over that height.
  /// Time constant with which the ground gives, critically damped. None: it is rigid, or has 1 ms
  /// where the engine knows soft contact alone. That engine gives it to the ends of joints' ranges
  /// too, and takes no less than two of its steps; at 1 ms and steps of 0.5 ms its impulses of
  /// impacts are within 1 % of rigid ones, softer ground gives up to a tenth more.
  std::optional<double> contact_time_constant_s = std::nullopt;
};

/// A robot over ground that is level between edges, with its rotors and mechanisms, that moves on
/// by steps of time. It knows no motor and no controller: forces come from outside and are held
/// over a step. Vectors as in hopper::WholeBody of the same robot: positions and velocities of the
/// tree, forces per velocity. One object serves one thread.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Name in options and documents: "own", "mujoco".
  virtual std::string_view name() const = 0;

  /// Starts anew at that position and velocity and forgets the past. std::invalid_argument on wrong
  /// sizes or numbers that are not finite.
  virtual void start(const dynamics::VectorIn& position, const dynamics::VectorIn& velocity) = 0;

  /// Moves on by step_s while `force` (n x 1) acts. Unless it is kStepped, nothing has moved.
  [[nodiscard]] virtual EngineOutcome step(const dynamics::VectorIn& force, double step_s) = 0;

  virtual const Eigen::VectorXd& position() const = 0;
  virtual const Eigen::VectorXd& velocity() const = 0;

  /// Impulses of the last step by contact point of the robot (3 each, world's axes, on the robot);
  /// zero where it was open.
  virtual const Eigen::VectorXd& impulses_N_s() const = 0;
  /// J^T of these impulses (n x 1).
  virtual const Eigen::VectorXd& generalised_impulse() const = 0;
};

/// Makes an engine with contact by simulation/contact, rigid unless the options say otherwise. The
/// robot must outlive it.
std::unique_ptr<Engine> own_engine(const Robot& robot, const EngineOptions& options);

/// Makes an engine with MuJoCo, built from what `robot export` writes. Null where the program was
/// built without it: mujoco_absence() says what to do then. The robot must outlive the engine.
std::unique_ptr<Engine> mujoco_engine(const Robot& robot, const EngineOptions& options);

/// Returns a sentence on why MuJoCo is absent; none where it is there.
std::optional<std::string> mujoco_absence();

}  // namespace torquewright::hopper
