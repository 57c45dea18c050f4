// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/plant.hpp"

namespace torquewright::simulation {

/// An inertia on one joint, and a weight on a rod: a flywheel, a pendulum, or a mass on a linear
/// axis.
class SingleJoint : public Plant {
 public:
  /// `inertia_kg_m2` is about the joint's axis (kg on a linear axis), `gravity_Nm` is m g l of a
  /// weight that hangs down at position 0.
  explicit SingleJoint(double inertia_kg_m2, double gravity_Nm = 0.0)
      : inertia_kg_m2_(inertia_kg_m2), gravity_Nm_(gravity_Nm) {}

  Eigen::Index joint_count() const override { return 1; }
  void mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass_kg_m2) override;
  void bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
            Eigen::VectorXd& torque_Nm) override;
  double energy_J(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s) override;

 private:
  double inertia_kg_m2_;
  double gravity_Nm_;
};

}  // namespace torquewright::simulation
