// SPDX-License-Identifier: Apache-2.0
#include "simulation/plants/serial_arm.hpp"

#include <utility>

namespace torquewright::simulation {

SerialArm::SerialArm(std::vector<dynamics::SerialLink> links, double gravity_m_s2)
    : arm_(std::move(links), gravity_m_s2) {}

void SerialArm::mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass_kg_m2) {
  arm_.mass_matrix(position_rad, mass_kg_m2);
}

void SerialArm::bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
                     Eigen::VectorXd& torque_Nm) {
  arm_.bias(position_rad, speed_rad_s, torque_Nm);
}

double SerialArm::energy_J(const Eigen::VectorXd& position_rad,
                           const Eigen::VectorXd& speed_rad_s) {
  return arm_.kinetic_energy_J(position_rad, speed_rad_s) + arm_.potential_energy_J(position_rad);
}

}  // namespace torquewright::simulation
