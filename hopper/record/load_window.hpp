// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hopper/check/transmission_load.hpp"
#include "hopper/demand/contact_load.hpp"

namespace torquewright::hopper {

/// Motion and torque of the drives in a simulated run, step by step, at the drives' outputs.
struct DriveSteps {
  std::vector<double> times_s;         ///< At which each step begins, and at which the last ends.
  Eigen::MatrixXd torque_Nm;           ///< (drives x steps): what acted on rotor and load.
  Eigen::MatrixXd speed_before_rad_s;  ///< (drives x steps): at the step's beginning,
  Eigen::MatrixXd speed_after_rad_s;   ///< and at its end, after its impacts.
  Eigen::MatrixXd contact_Nm_s;        ///< (drives x steps): A^-T J^T of the contacts' impulses.
  /// (drives x steps): what the turning of their carriers changed of the rotors' angular momenta
  /// (WholeBody::carried_momenta); empty: nothing.
  Eigen::MatrixXd carried_Nm_s;
  /// Whether a contact began in the step. What changes the rotor's speed in it then counts as an
  /// impact's impulse, by its size, as in the check; empty: none is told from steady torque, and
  /// all counts by its sign.
  std::vector<bool> has_impact;
};

/// Computes the greatest load of each drive's gears: the mean over the worst window of that length,
/// wherever it begins; a run shorter than it is one window. One for each drive, judged by its
/// limit. A step's impulse through the mesh is known whole, so that nothing is left to doubt.
/// docs/derivations/whole_body_check.md eqs. (12), (16), (17). Requires ascending times, finite
/// numbers and matching sizes: std::invalid_argument.
std::vector<TransmissionLoad> transmission_loads(const Robot& robot, const DriveSteps& steps,
                                                 double window_s);

/// Computes what the contacts ask of each drive at most, as a mean over such a window; eq. (20). A
/// run does not tell a step's impact from what the ground gives besides: `impulse_Nm_s` is the
/// greatest of one step, and `steady_joint_Nm` the worst window without the steps in which contact
/// began.
std::vector<ContactLoad> contact_loads(const Robot& robot, const DriveSteps& steps,
                                       double window_s);

}  // namespace torquewright::hopper
