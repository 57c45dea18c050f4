// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/motions/walk_trial.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace torquewright::test {
namespace {

using Eigen::VectorXd;

constexpr double kStep_s = 1e-4;
constexpr int kStepsAControl = 10;
constexpr double kAfter_s = 0.05;
constexpr double kPatience_s = 0.08;  ///< After the planned impact: the foot lands or will not.

/// What is reported of the samples; the foot that stood is `stance`.
void judge(WalkResult& result, std::size_t stance, double before_s) {
  const double from_s = std::max(0.0, result.contact_s), until_s = from_s + kAfter_s;
  double squares[2] = {0.0, 0.0};
  int count = 0;
  for (const WalkSample& sample : result.samples) {
    if (sample.time_s < -before_s || sample.time_s > until_s) continue;
    result.peak_torque_Nm = std::max(result.peak_torque_Nm, sample.torque_Nm.cwiseAbs().maxCoeff());
    if (sample.time_s < from_s) continue;
    ++count;
    for (Eigen::Index joint = 0; joint < kWalkJoints; ++joint) {
      squares[joint % 2] += sample.rate_error_rad_s[joint] * sample.rate_error_rad_s[joint];
    }
  }
  result.other_leg_rad_s = std::sqrt(squares[stance] / count);
  result.landing_leg_rad_s = std::sqrt(squares[1 - stance] / count);
}

}  // namespace

VectorXd swing_push(const hopper::Robot& robot, const WalkInstant& instant, std::size_t stance,
                    double speed_m_s) {
  dynamics::TreeState state(robot.tree);
  state.set(instant.position, instant.velocity);
  Eigen::MatrixXd rows(4, kWalkVelocities);
  rows << foot_rows(state, robot.contacts.at(stance).point),
      foot_rows(state, robot.contacts.at(1 - stance).point);
  return rows.completeOrthogonalDecomposition().solve(Eigen::Vector4d(0.0, 0.0, 0.0, speed_m_s));
}
WalkResult walk(const hopper::Robot& robot, const Walk& reference, const WalkTrial& trial) {
  const WalkMode& mode = reference.at(trial.before);
  WalkControl control(robot, reference, trial.before, trial.control);
  const auto plant = trial.is_stepped ? stepping_plant(robot, mode.stance)
                                      : held_plant(robot, mode.stance, trial.ground_height_m);
  const WalkInstant begin = mode.at(mode.from_s());
  WalkState state{begin.position,
                  begin.velocity + swing_push(robot, begin, mode.stance, trial.swing_push_m_s)};
  WalkResult result;
  const double middle_s = 0.5 * (mode.from_s() + mode.until_s());
  VectorXd torque_Nm;
  for (int step = 0;; ++step) {
    const double time_s = mode.from_s() + kStep_s * step;
    const double since_s = time_s - control.impact_s();
    const double end_s =
        result.has_landed ? std::max(0.0, result.contact_s) + kAfter_s : kPatience_s;
    if (since_s > end_s) break;
    if (step % kStepsAControl == 0) {
      torque_Nm = control.torque_Nm(time_s, state.position, state.velocity);
      const VectorXd error = control.wanted(time_s).velocity - state.velocity;
      result.samples.push_back({since_s, torque_Nm, error.tail(kWalkJoints)});
    }
    const std::optional<double> landed = plant->step(state, torque_Nm, kStep_s, time_s > middle_s);
    if (!landed) continue;
    result.has_landed = true;
    result.contact_s = since_s + *landed * kStep_s;
  }
  if (result.has_landed) judge(result, mode.stance, 1.5 * trial.control.impact.window_s);
  return result;
}

}  // namespace torquewright::test
