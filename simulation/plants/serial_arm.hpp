// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/serial_arm.hpp"
#include "simulation/plant.hpp"

namespace torquewright::simulation {

/// A planar serial arm with an actuator in each joint; at position 0 it hangs down.
class SerialArm : public Plant {
 public:
  SerialArm(std::vector<dynamics::SerialLink> links, double gravity_m_s2);

  Eigen::Index joint_count() const override { return arm_.joint_count(); }
  void mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass_kg_m2) override;
  void bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
            Eigen::VectorXd& torque_Nm) override;
  double energy_J(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s) override;

 private:
  dynamics::SerialArm arm_;
};

}  // namespace torquewright::simulation
