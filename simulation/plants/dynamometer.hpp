// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/plant.hpp"

namespace torquewright::simulation {

/// One joint whose motion a far stronger machine imposes, as the excitation says.
class Dynamometer : public Plant {
 public:
  Eigen::Index joint_count() const override { return 1; }
  bool is_imposed() const override { return true; }
  void mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass_kg_m2) override;
  void bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
            Eigen::VectorXd& torque_Nm) override;
  double energy_J(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s) override;
};

}  // namespace torquewright::simulation
