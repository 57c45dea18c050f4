// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hopper/tracking/controller.hpp"
#include "hopper/tracking/reference_clock.hpp"

namespace torquewright::hopper {

/// Cost with which the recursion for the gains begins, at the motion's end.
enum class LqrEnd {
  kSteadyState,  ///< Cost of standing for ever as in the motion's last sample.
  kWeights,      ///< Cost of errors in a tenth of a second: for motions that end moving.
};

/// Errors and torques that cost the same (Bryson's rule: each weight is one by the square), and the
/// period. docs/derivations/tracking.md, "Weights".
struct LqrOptions {
  double control_period_s = 5e-4;  ///< Time between looks; torques are held over it.
  double place_m = 0.05;           ///< Error of the base's position.
  double tilt_rad = 0.1;           ///< Error of the base's angle about level axes.
  double joint_rad = 0.2;          ///< Error of every joint; in m where it is prismatic.
  double speed_m_s = 0.5;          ///< Error of the base's velocity.
  double turn_rate_rad_s = 1.0;    ///< Error of the base's angular velocity.
  double joint_rate_rad_s = 2.0;   ///< Error of every joint's rate.
  double torque_share = 0.05;      ///< Torque as a share of each drive's peak torque.
  /// Upper bound of that torque, as a share of the torque with which the foot of the last stance
  /// and, where it weighs, what touches then begins to tip (tipping_torque.hpp), where it can.
  double tipping_share = 0.5;
  /// Height by which points that are to land at once come down one after the other; counts for a
  /// tenth of a second. Some two millimetres are what a sole gives.
  double uneven_m = 0.002;
  /// Error at which a drive gives its peak torque to a foot that is off the ground and should not
  /// be. Stiffer ones throw a robot that a look at the foot misjudges.
  double lifted_rad = 1.5;
  /// Torques by drive, at its output, in place of the two shares; empty: the shares hold.
  Eigen::VectorXd torque_Nm;
  LqrEnd end = LqrEnd::kSteadyState;
  /// Whether the model of errors is kept beside the gains, for a controller whose torques act late.
  bool foretells = false;
  /// Whether it weighs the robot from the motion's begin, where it stands, to the first impact, and
  /// goes on with what that told of its masses.
  bool weighs = false;
};

/// Gains of a whole motion, for any number of controllers and threads.
class GainSchedule;

enum class GainOutcome {
  kFound,
  kUnreached,      ///< A mechanism does not reach a posture of the motion.
  kNoSteadyState,  ///< The motion's end cannot be held: doubling did not converge.
  kBlownUp,        ///< Costs grew beyond all numbers: errors that no torque reaches.
};

struct LqrResult {
  GainOutcome outcome = GainOutcome::kFound;
  std::shared_ptr<const GainSchedule> gains;  ///< The gains; null unless kFound.
  double time_s = 0.0;                        ///< Time in the motion at which it ended otherwise.
  ReferenceInstant instant;                   ///< State there.
};

/// Describes the outcome, with the time; empty for kFound.
std::string sentence_of(const LqrResult& result);

/// Time-varying linear quadratic regulator along a reference, through its contact modes and
/// impacts (Anderson, Moore, "Optimal control", 1990; docs/derivations/tracking.md). Some 0.1 ms a
/// control period. std::invalid_argument where options are not positive or of a wrong size.
[[nodiscard]] LqrResult lqr_gains(const Robot& robot, const Reference& reference,
                                  const LqrOptions& options);

/// The reference's torques and, for errors of the whole state, the gains' part. Where the robot
/// stands in the world and which way it faces is no error. Robot and reference (those of the gains)
/// must outlive it. std::invalid_argument without gains.
std::unique_ptr<Controller> lqr_controller(const Robot& robot, const Reference& reference,
                                           std::shared_ptr<const GainSchedule> gains,
                                           const ClockOptions& clock, const ImpactOptions& impact);

}  // namespace torquewright::hopper
