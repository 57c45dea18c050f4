// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/checked_motion.hpp"

namespace torquewright::hopper {

/// Drives that one battery feeds, all at once.
struct SharedBus {
  std::vector<std::size_t> drives;
  double open_circuit_V = 0.0;
  Eigen::VectorXd voltage_V;  ///< By sample, under the power that all drives ask for.
  double least_V = 0.0;
  double least_time_s = 0.0;
  double greatest_power_W = 0.0;
  double power_time_s = 0.0;
  double power_limit_W = 0.0;  ///< Of the battery; may be infinite.
  std::size_t starved = 0;     ///< Samples whose power it cannot deliver.
};

/// The batteries that feed two or more drives, and their voltage over the motion.
/// `torques_Nm` by drive and sample, rotors included. docs/derivations/whole_body_check.md eq.
/// (13).
std::vector<SharedBus> shared_buses(const CheckedMotion& checked,
                                    const Eigen::MatrixXd& torques_Nm);

/// What there is to say of them: a note, or a violation where one gives out.
std::vector<Finding> shared_bus_findings(const CheckedMotion& checked,
                                         const std::vector<SharedBus>& buses);

}  // namespace torquewright::hopper
