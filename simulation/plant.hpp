// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::simulation {

/// The load of n actuators: torque = M(q) a + h(q, v), where the torque is that of the actuators on
/// the plant. q, v, h are (n x 1) in rad, rad/s and N m, M is (n x n) in kg m^2, symmetric and
/// positive definite; joints that slide count m, m/s, N and kg under the same names. Callers bring
/// vectors and matrices of these sizes, implementations fill every element and may keep what they
/// need to compute: one object serves one thread.
class Plant {
 public:
  virtual ~Plant() = default;

  virtual Eigen::Index joint_count() const = 0;

  /// Whether the motion comes from outside (an excitation's speeds), so that the torque follows
  /// from it; then M, h and the energy are not asked for. Only for plants of one joint.
  virtual bool is_imposed() const { return false; }

  virtual void mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass_kg_m2) = 0;

  /// Writes h: gravity, Coriolis and centrifugal torques.
  virtual void bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
                    Eigen::VectorXd& torque_Nm) = 0;

  /// Kinetic and potential energy, from an arbitrary zero.
  virtual double energy_J(const Eigen::VectorXd& position_rad,
                          const Eigen::VectorXd& speed_rad_s) = 0;

 protected:
  Plant() = default;
  Plant(const Plant&) = default;
  Plant& operator=(const Plant&) = default;
};

}  // namespace torquewright::simulation
