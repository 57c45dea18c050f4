// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hopper/tracking/controller.hpp"
#include "hopper/tracking/reference_clock.hpp"

namespace torquewright::hopper {

/// The cost with which the recursion for the gains begins, at the motion's end.
enum class LqrEnd {
  kSteadyState,  ///< Of standing as the motion's last sample does, for ever.
  kWeights,      ///< Of what errors cost in a tenth of a second: for motions that end moving.
};

/// Errors and torques that cost the same (Bryson's rule: each weight is one by the square), and the
/// period. docs/derivations/tracking.md, "Weights".
struct LqrOptions {
  double control_period_s = 5e-4;  ///< Between looks; torques are held.
  double place_m = 0.05;           ///< Of the base.
  double tilt_rad = 0.1;           ///< Of the base, about level axes.
  double joint_rad = 0.2;          ///< Of every joint; m where it is prismatic.
  double speed_m_s = 0.5;          ///< Of the base.
  double turn_rate_rad_s = 1.0;    ///< Of the base.
  double joint_rate_rad_s = 2.0;   ///< Of every joint.
  double torque_share = 0.05;      ///< Of each drive's peak torque, but no more than
  /// this share of the torque with which the foot of the last stance begins to tip
  /// (tipping_torque.hpp), where it can.
  double tipping_share = 0.5;
  Eigen::VectorXd torque_Nm;  ///< By drive, at its output, instead; empty: as above.
  LqrEnd end = LqrEnd::kSteadyState;
};

/// Gains of a whole motion, for any number of controllers and threads.
class GainSchedule;

enum class GainOutcome {
  kFound,
  kUnreached,      ///< A mechanism does not reach a posture of the motion.
  kNoSteadyState,  ///< Nothing holds the motion's end: doubling did not converge.
  kBlownUp,        ///< Costs grew beyond all numbers: errors that no torque reaches.
};

struct LqrResult {
  GainOutcome outcome = GainOutcome::kFound;
  std::shared_ptr<const GainSchedule> gains;  ///< Null unless kFound.
  double time_s = 0.0;                        ///< Where in the motion it ended otherwise,
  ReferenceInstant instant;                   ///< and the state there.
};

/// Says what happened, with the time; empty for kFound.
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
