// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/mechanism.hpp"

#include <Eigen/LU>

namespace torquewright::hopper {

std::vector<MechanismMargin> Mechanism::margins(const SmallVector&) const { return {}; }

SmallVector actuator_torque_Nm(const Transfer& transfer, const SmallVector& joint_Nm) {
  return transfer.jacobian.transpose().partialPivLu().solve(joint_Nm);
}

SmallMatrix reflected_inertia_kg_m2(const Transfer& transfer, const SmallVector& armature_kg_m2) {
  return transfer.jacobian.transpose() * armature_kg_m2.asDiagonal() * transfer.jacobian;
}

SmallVector rotor_torque_Nm(const Transfer& transfer, const SmallVector& armature_kg_m2,
                            const SmallVector& joint_rad_s, const SmallVector& joint_rad_s2) {
  const SmallVector rotor_rad_s2 =
      transfer.jacobian * joint_rad_s2 + transfer.jacobian_rate_1_s * joint_rad_s;
  return transfer.jacobian.transpose() * armature_kg_m2.cwiseProduct(rotor_rad_s2);
}

}  // namespace torquewright::hopper
