// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"
#include "robot/model/drive_supply.hpp"

namespace torquewright::hopper {

/// A supply of a robot and the power that all of its drives ask of it, with what their lines lose.
struct BatteryPower {
  DriveSupply feeds;
  Eigen::VectorXd power_W;  ///< By sample; negative: returned.
};

/// Of every supply. `torques_Nm` is by drive and sample, rotors included.
std::vector<BatteryPower> battery_powers(const CheckedMotion& checked,
                                         const Eigen::MatrixXd& torques_Nm);

/// Drives that one battery feeds together.
struct SharedBus {
  std::vector<std::size_t> drives;
  double open_circuit_V = 0.0;
  Eigen::VectorXd voltage_V;  ///< Voltage by sample, under the power that all drives ask for.
  double least_V = 0.0;
  double least_time_s = 0.0;
  double greatest_power_W = 0.0;
  double power_time_s = 0.0;
  double power_limit_W = 0.0;  ///< Greatest power of the battery; may be infinite.
  std::size_t starved = 0;     ///< Number of samples whose power it cannot deliver.
  double least_power_W = 0.0;  ///< Least power; negative: all drives together return it.
  double return_time_s = 0.0;
  /// Power that the battery takes back at most, negative; may be infinite.
  double return_limit_W = 0.0;
  std::size_t flooded = 0;  ///< Number of samples whose power it cannot take back.
};

/// Returns the batteries that feed two or more drives, and their voltage over the motion.
/// `torques_Nm` is by drive and sample, rotors included (docs/derivations/whole_body_check.md eq.
/// (13)).
std::vector<SharedBus> shared_buses(const CheckedMotion& checked,
                                    const Eigen::MatrixXd& torques_Nm);

/// Describes how a battery is overloaded; empty where it is not.
std::string overload_of(const SharedBus& bus);

/// Returns a finding on each battery: a note, or a violation where it is overloaded.
std::vector<Finding> shared_bus_findings(const CheckedMotion& checked,
                                         const std::vector<SharedBus>& buses);

}  // namespace torquewright::hopper
