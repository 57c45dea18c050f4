// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/controller.hpp"
#include "hopper/tracking/reference_clock.hpp"

namespace torquewright::hopper {

/// Gains of the loop about every drive. docs/derivations/tracking.md, "Drives of their own".
struct PdOptions {
  /// A drive gives its peak torque for this error of its output: its stiffness is the one by the
  /// other. Smaller: the feet tip before the body leans; greater: gravity bends the posture.
  double full_torque_error_rad = 0.5;
  /// Share of critical damping with the inertia that the drive moves in the air, the least it ever
  /// has.
  double damping_ratio = 1.0;
  Eigen::VectorXd stiffness_Nm_rad;  ///< By drive, at its output, instead; empty: as above.
  Eigen::VectorXd damping_Nm_s_rad;  ///< The same.
};

struct PdGains {
  Eigen::VectorXd stiffness_Nm_rad;  ///< (drives x 1)
  Eigen::VectorXd damping_Nm_s_rad;
};

/// In the posture in which the reference begins. std::invalid_argument where stated gains are not
/// one per drive, or a mechanism does not reach that posture.
PdGains pd_gains(const Robot& robot, const Reference& reference, const PdOptions& options);

/// The reference's torques and, for errors of the drives' positions and speeds, more of them.
/// Robot and reference must outlive it. Throws as pd_gains().
std::unique_ptr<Controller> pd_controller(const Robot& robot, const Reference& reference,
                                          const PdOptions& options, const ClockOptions& clock,
                                          const ImpactOptions& impact);

}  // namespace torquewright::hopper
