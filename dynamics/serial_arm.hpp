// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "dynamics/gravity.hpp"

namespace torquewright::dynamics {

/// One rigid link of a planar arm. Distances run along the link, from its own joint.
struct SerialLink {
  double mass_kg = 0;
  double length_m = 0;  ///< Length to the next joint; of the last link, to its tip.
  /// Centre of mass; it may lie beyond the length, or behind the joint (negative).
  double center_of_mass_m = 0;
  double inertia_kg_m2 = 0;  ///< Inertia about the centre of mass.
};

/// The parameters in which a link's dynamics are linear.
struct SerialLinkParameters {
  double mass_kg = 0;
  double first_moment_kg_m = 0;    ///< Mass times centre of mass.
  double joint_inertia_kg_m2 = 0;  ///< Inertia about the link's own joint.
};
SerialLinkParameters parameters_of(const SerialLink& link);

/// Number of parameters of one link, which are also the regressor's columns per link, in the
/// struct's order.
inline constexpr Eigen::Index kParametersPerLink = 3;

/// Chain of revolute joints in a vertical plane, base fixed; a pendulum is one of a single link.
/// Positions are relative to the link before, 0 hangs straight down (docs/notation.md, "Frames").
/// Holds no rotors: what reflects through a gear is added to the joint's inertia by the caller.
///
///   torque = M(position) acceleration + h(position, velocity)
///          = Y(position, velocity, acceleration) parameters
///
/// docs/derivations/serial_arm.md. No function allocates; one object serves one thread. Vectors
/// have as many elements as there are links; std::invalid_argument if not.
class SerialArm {
 public:
  using Vector = Eigen::Ref<const Eigen::VectorXd>;
  using VectorOut = Eigen::Ref<Eigen::VectorXd>;
  using MatrixOut = Eigen::Ref<Eigen::MatrixXd>;

  /// std::invalid_argument without links, or where a number is not finite.
  explicit SerialArm(std::vector<SerialLink> links, double gravity_m_s2 = kGravity_m_s2);

  Eigen::Index joint_count() const { return joints_; }
  std::span<const SerialLink> links() const { return links_; }
  /// The parameters that the regressor is multiplied with: (3 joints x 1).
  const Eigen::VectorXd& parameters() const { return parameters_; }

  /// Writes the regressor Y (joints x 3 joints), eqs. (5)-(8); columns 3 i to 3 i + 2 belong to
  /// link i. Uses the links' lengths and gravity, not their masses, centres and inertias.
  void regressor(const Vector& position_rad, const Vector& velocity_rad_s,
                 const Vector& acceleration_rad_s2, MatrixOut out);
  /// Computes the torques Y parameters; eqs. (5)-(8).
  void inverse_dynamics(const Vector& position_rad, const Vector& velocity_rad_s,
                        const Vector& acceleration_rad_s2, VectorOut torque_Nm);
  /// Writes the mass matrix (joints x joints), kg m2; eq. (4).
  void mass_matrix(const Vector& position_rad, MatrixOut out);
  /// Computes Coriolis, centrifugal and gravity torques, which hold accelerations at zero.
  void bias(const Vector& position_rad, const Vector& velocity_rad_s, VectorOut torque_Nm);

  double kinetic_energy_J(const Vector& position_rad, const Vector& velocity_rad_s);
  /// Potential energy; zero with all mass at the height of the first joint.
  double potential_energy_J(const Vector& position_rad);

 private:
  struct Direction {
    Eigen::Vector2d along;   // from the joint to the tip; x forward, z up
    Eigen::Vector2d across;  // where the tip goes when the angle grows
  };
  void set_directions(const Vector& position_rad);
  void require_size(const Vector& vector) const;

  std::vector<SerialLink> links_;
  double gravity_m_s2_;
  Eigen::Index joints_;
  Eigen::VectorXd parameters_;
  // Room to work in, so that no call allocates.
  std::vector<Direction> directions_;
  Eigen::VectorXd zero_;
  Eigen::VectorXd torque_Nm_;
  Eigen::MatrixXd regressor_;
  Eigen::MatrixXd mass_matrix_;
};

}  // namespace torquewright::dynamics
