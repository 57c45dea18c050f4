// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::hopper {

/// Between which torques a robot's drives are held, for a controller that asks for none beyond. May
/// be asked by several threads at once.
class DriveRanges {
 public:
  virtual ~DriveRanges() = default;
  /// Writes them for outputs that turn at these speeds behind these voltages and with these winding
  /// temperatures (drives x 1 each); empty voltages and temperatures are those of the start.
  virtual void at(const Eigen::VectorXd& speed_rad_s, const Eigen::VectorXd& bus_V,
                  const Eigen::VectorXd& winding_K, Eigen::VectorXd& least_Nm,
                  Eigen::VectorXd& greatest_Nm) const = 0;
};

}  // namespace torquewright::hopper
