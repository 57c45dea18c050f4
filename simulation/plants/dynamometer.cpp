// SPDX-License-Identifier: Apache-2.0
#include "simulation/plants/dynamometer.hpp"

namespace torquewright::simulation {

void Dynamometer::mass_matrix(const Eigen::VectorXd& /*position_rad*/,
                              Eigen::MatrixXd& mass_kg_m2) {
  mass_kg_m2.setZero();
}

void Dynamometer::bias(const Eigen::VectorXd& /*position_rad*/,
                       const Eigen::VectorXd& /*speed_rad_s*/, Eigen::VectorXd& torque_Nm) {
  torque_Nm.setZero();
}

double Dynamometer::energy_J(const Eigen::VectorXd& /*position_rad*/,
                             const Eigen::VectorXd& /*speed_rad_s*/) {
  return 0.0;
}

}  // namespace torquewright::simulation
