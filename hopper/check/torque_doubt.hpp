// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/drive_check/report.hpp"
#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// (drives x samples), Nm: how far torques of the dynamics may be off.
///
/// Where accelerations are derived: what changes when they look twice as far to either side, the
/// largest of the samples within that reach; it holds what noise is left and what smoothing takes
/// away. Where steps or noise decided the window, what the motion's acceleration_doubt makes
/// besides. Where contact forces are not unique: as far as they let the torque go. Where
/// accelerations are given: four standard deviations of the torques' own noise.
/// docs/derivations/whole_body_check.md, "Doubt".
Eigen::MatrixXd torque_doubts(const CheckedMotion& checked);

/// Returns the demand with accelerations that look twice as far; empty where accelerations are
/// given, or the motion is too short.
std::optional<Demand> demand_twice_as_far(const CheckedMotion& checked);

/// Computes the same doubts from that demand.
Eigen::MatrixXd torque_doubts(const CheckedMotion& checked, const std::optional<Demand>& twice);

/// Bounds of one drive's peak torque.
struct PeakDoubt {
  std::string drive;
  double peak_Nm = 0.0;
  double time_s = 0.0;
  double least_Nm = 0.0;    ///< The peak is no less than this.
  double most_Nm = 0.0;     ///< The peak is no more than this.
  bool by_sharing = false;  ///< Most of the doubt is that contact forces are not unique.
};

/// Returns the peaks by drive, from torques and doubts by drive and sample.
std::vector<PeakDoubt> peak_doubts(const CheckedMotion& checked, const Eigen::MatrixXd& torque_Nm,
                                   const Eigen::MatrixXd& doubt_Nm);

/// Returns findings on drives whose peak is not known well enough, or whose verdict the doubt
/// leaves open.
std::vector<Finding> doubt_findings(const CheckedMotion& checked,
                                    const std::vector<PeakDoubt>& peaks,
                                    const std::vector<actuator::DriveReport>& drives);

}  // namespace torquewright::hopper
