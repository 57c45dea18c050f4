// SPDX-License-Identifier: Apache-2.0
#include "hopper/mechanisms/mechanism.hpp"

#include <Eigen/LU>

namespace torquewright::hopper {

std::vector<MechanismMargin> Mechanism::margins(const SmallVector&) const { return {}; }

SmallVector joint_torque_Nm(const Transfer& transfer, const SmallVector& actuator_Nm) {
  return transfer.jacobian.transpose() * actuator_Nm;
}

SmallVector actuator_torque_Nm(const Transfer& transfer, const SmallVector& joint_Nm) {
  return transfer.jacobian.transpose().partialPivLu().solve(joint_Nm);
}

}  // namespace torquewright::hopper
