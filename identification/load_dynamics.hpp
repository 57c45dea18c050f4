// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>

#include "dynamics/serial_arm.hpp"
#include "identification/rig.hpp"

namespace torquewright::identification {

/// What moves beyond the actuators: torque = M(position) acceleration + bias(position, speed). On a
/// linear axis: m, kg, N.
class LoadDynamics {
 public:
  explicit LoadDynamics(const Rig& rig);

  Eigen::Index joint_count() const { return joints_; }
  bool is_imposed() const { return load_.type == LoadType::kDynamometer; }

  void mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass) const;
  void bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
            Eigen::VectorXd& torque_Nm) const;
  double energy_J(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s) const;

 private:
  Load load_;
  Eigen::Index joints_;
  double inertia_kg_m2_ = 0.0;  ///< Of a single joint, about its axis (kg on a linear axis).
  double gravity_Nm_ = 0.0;     ///< m g l.
  std::unique_ptr<dynamics::SerialArm> arm_;
};

}  // namespace torquewright::identification
