// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/drive_loops.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "hopper/tracking/linearisation.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What each drive moves in the air, the others free: the inverse of its speed's answer to an
/// impulse of its own; (drives x 1).
VectorXd least_inertias_kg_m2(WholeBody& body) {
  const Index n = body.state().tree().velocity_size();
  Eigen::MatrixXd mass(n, n);
  body.mass_matrix(mass);
  const Eigen::MatrixXd drives = drive_jacobian(body);
  const Eigen::MatrixXd answer = drives * mass.llt().solve(drives.transpose());
  return answer.diagonal().cwiseInverse();
}

void require_gains(const VectorXd& stated, Index drives) {
  const bool is_right = stated.size() == 0 || (stated.size() == drives && stated.allFinite() &&
                                               (stated.array() >= 0.0).all());
  if (!is_right) throw std::invalid_argument("pd: one gain per drive, none below zero");
}

}  // namespace

Eigen::VectorXd peak_torques_Nm(const Robot& robot) {
  std::vector<double> peaks_Nm;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& one : drivetrain.actuators) {
      const double electric_Nm = one.motor.torque_constant_Nm_A * one.drive.peak_current_A *
                                 std::abs(one.transmission.ratio) *
                                 one.transmission.forward_efficiency;
      peaks_Nm.push_back(std::min(electric_Nm, one.transmission.peak_torque_Nm));
    }
  }
  return Eigen::Map<Eigen::VectorXd>(peaks_Nm.data(), static_cast<Eigen::Index>(peaks_Nm.size()));
}

PdGains pd_gains(const Robot& robot, const Reference& reference, const PdOptions& options) {
  const VectorXd peaks_Nm = peak_torques_Nm(robot);
  require_gains(options.stiffness_Nm_rad, peaks_Nm.size());
  require_gains(options.damping_Nm_s_rad, peaks_Nm.size());
  if (!(options.full_torque_error_rad > 0.0) || !(options.damping_ratio >= 0.0)) {
    throw std::invalid_argument("pd: errors above zero, no damping below it");
  }
  WholeBody body(robot);
  ReferenceInstant first;
  reference.at(reference.begins_s(), first);
  if (!body.set(first.position, first.velocity)) {
    throw std::invalid_argument("pd: a mechanism does not reach the motion's first posture");
  }
  PdGains gains{options.stiffness_Nm_rad, options.damping_Nm_s_rad};
  if (gains.stiffness_Nm_rad.size() == 0) {
    gains.stiffness_Nm_rad = peaks_Nm / options.full_torque_error_rad;
  }
  if (gains.damping_Nm_s_rad.size() == 0) {
    gains.damping_Nm_s_rad =
        2.0 * options.damping_ratio *
        gains.stiffness_Nm_rad.cwiseProduct(least_inertias_kg_m2(body)).cwiseSqrt();
  }
  return gains;
}

}  // namespace torquewright::hopper
