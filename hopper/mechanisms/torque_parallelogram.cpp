// SPDX-License-Identifier: Apache-2.0
#include "hopper/mechanisms/torque_parallelogram.hpp"

#include <Eigen/LU>

namespace torquewright::hopper {

using Eigen::Vector2d;

TorqueParallelogram::TorqueParallelogram(const Transfer& transfer, const Vector2d& least_Nm,
                                         const Vector2d& most_Nm)
    : jacobian_(transfer.jacobian), least_Nm_(least_Nm), most_Nm_(most_Nm) {}

std::array<Vector2d, 4> TorqueParallelogram::corners_Nm() const {
  const auto corner = [&](double first, double second) -> Vector2d {
    return jacobian_.transpose() * Vector2d(first, second);
  };
  return {corner(least_Nm_[0], least_Nm_[1]), corner(most_Nm_[0], least_Nm_[1]),
          corner(most_Nm_[0], most_Nm_[1]), corner(least_Nm_[0], most_Nm_[1])};
}

Vector2d TorqueParallelogram::actuator_Nm(const Vector2d& joint_Nm) const {
  return jacobian_.transpose().partialPivLu().solve(joint_Nm);
}

Vector2d TorqueParallelogram::margins_Nm(const Vector2d& joint_Nm) const {
  const Vector2d torque = actuator_Nm(joint_Nm);
  return (most_Nm_ - torque).cwiseMin(torque - least_Nm_);
}

double TorqueParallelogram::margin_Nm(const Vector2d& joint_Nm) const {
  return margins_Nm(joint_Nm).minCoeff();
}

}  // namespace torquewright::hopper
