// SPDX-License-Identifier: Apache-2.0
#include "simulation/plants/single_joint.hpp"

#include <cmath>

namespace torquewright::simulation {

void SingleJoint::mass_matrix(const Eigen::VectorXd& /*position_rad*/,
                              Eigen::MatrixXd& mass_kg_m2) {
  mass_kg_m2(0, 0) = inertia_kg_m2_;
}

void SingleJoint::bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& /*speed_rad_s*/,
                       Eigen::VectorXd& torque_Nm) {
  torque_Nm[0] = gravity_Nm_ * std::sin(position_rad[0]);
}

double SingleJoint::energy_J(const Eigen::VectorXd& position_rad,
                             const Eigen::VectorXd& speed_rad_s) {
  return 0.5 * inertia_kg_m2_ * speed_rad_s[0] * speed_rad_s[0] -
         gravity_Nm_ * std::cos(position_rad[0]);
}

}  // namespace torquewright::simulation
