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
  double least_power_W = 0.0;  ///< Negative: all drives together return it.
  double return_time_s = 0.0;
  double return_limit_W = 0.0;  ///< What the battery takes back, negative; may be infinite.
  std::size_t flooded = 0;      ///< Samples whose power it cannot take back.
};

/// The batteries that feed two or more drives, and their voltage over the motion.
/// `torques_Nm` by drive and sample, rotors included. docs/derivations/whole_body_check.md eq.
/// (13).
std::vector<SharedBus> shared_buses(const CheckedMotion& checked,
                                    const Eigen::MatrixXd& torques_Nm);

/// What there is to say of one that gives out or cannot take back; empty where it does neither.
std::string overload_of(const SharedBus& bus);

/// What there is to say of them: a note, or a violation where one is overloaded.
std::vector<Finding> shared_bus_findings(const CheckedMotion& checked,
                                         const std::vector<SharedBus>& buses);

}  // namespace torquewright::hopper
