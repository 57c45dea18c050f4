// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "dynamics/jet.hpp"

namespace torquewright::hopper {

/// A mechanism joins as many actuators as joints, at most this many.
constexpr int kMostJoints = 2;
template <typename T>
using SmallVectorOf = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, kMostJoints, 1>;
template <typename T>
using SmallMatrixOf = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, kMostJoints, kMostJoints>;
using SmallVector = SmallVectorOf<double>;
using SmallMatrix = SmallMatrixOf<double>;

/// How actuators move with the joints, at one posture and speed. No power is lost between them, so
/// that joint torques are the transposed Jacobian times the actuators' torques. k actuators on k
/// joints; docs/derivations/mechanisms.md eq. (1).
template <typename T>
struct TransferOf {
  SmallVectorOf<T> actuator_position_rad;  ///< (k x 1), of each output, behind its gearbox.
  SmallMatrixOf<T> jacobian;               ///< (k x k), actuators' speeds over joints' speeds.
  SmallMatrixOf<T> jacobian_rate_1_s;      ///< Its rate while the joints move so.
};
using Transfer = TransferOf<double>;

/// How far a mechanism is from what it cannot do or must not do.
struct MechanismMargin {
  std::string name;  ///< rod_1_angle, singularity, ...
  double value = 0.0;
  double limit = 0.0;
  double margin = 0.0;  ///< Positive inside.
  std::string unit;
};

/// What stands between actuators and joints. Revolute on both sides. Vectors have size() elements.
class Mechanism {
 public:
  virtual ~Mechanism() = default;

  /// Returns its name in documents.
  virtual std::string_view type() const = 0;
  /// Joints, and as many actuators.
  virtual Eigen::Index size() const = 0;
  /// Empty where the linkage does not reach the posture, or is singular there.
  virtual std::optional<Transfer> transfer(const SmallVector& joint_rad,
                                           const SmallVector& joint_rad_s) const = 0;
  /// The same closed forms on numbers that carry derivatives, by joints' positions and speeds or by
  /// what these depend on. (Not overloads: an expression of Eigen's converts to either.)
  virtual std::optional<TransferOf<dynamics::Jet>> transfer_with_slopes(
      const SmallVectorOf<dynamics::Jet>& joint_rad,
      const SmallVectorOf<dynamics::Jet>& joint_rad_s) const = 0;
  virtual std::optional<TransferOf<dynamics::Jet2>> transfer_with_curvatures(
      const SmallVectorOf<dynamics::Jet2>& joint_rad,
      const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const = 0;
  /// Returns the margins at a posture; empty: nothing limits it but the joints.
  virtual std::vector<MechanismMargin> margins(const SmallVector& joint_rad) const;
  /// Returns the Jacobian where it is the same in every posture; else none.
  virtual std::optional<SmallMatrix> constant_jacobian() const { return std::nullopt; }
};

/// Whichever of the three it is.
template <typename T>
std::optional<TransferOf<T>> transfer_of(const Mechanism& mechanism,
                                         const SmallVectorOf<T>& joint_rad,
                                         const SmallVectorOf<T>& joint_rad_s) {
  if constexpr (std::is_same_v<T, dynamics::Jet>) {
    return mechanism.transfer_with_slopes(joint_rad, joint_rad_s);
  } else if constexpr (std::is_same_v<T, dynamics::Jet2>) {
    return mechanism.transfer_with_curvatures(joint_rad, joint_rad_s);
  } else {
    return mechanism.transfer(joint_rad, joint_rad_s);
  }
}

/// J^T torques of the actuators, eq. (2).
template <typename T>
SmallVectorOf<T> joint_torque_Nm(const TransferOf<T>& transfer,
                                 const std::type_identity_t<SmallVectorOf<T>>& actuator_Nm) {
  return transfer.jacobian.transpose() * actuator_Nm;
}

/// The actuators' torques that make these at the joints, eq. (2). Requires a Jacobian that is not
/// singular, as those of Mechanism::transfer() are.
SmallVector actuator_torque_Nm(const Transfer& transfer, const SmallVector& joint_Nm);

/// J^T diag(armature) J, eq. (3): what the rotors weigh at the joints. Armatures are N^2 J, one per
/// actuator.
SmallMatrix reflected_inertia_kg_m2(const Transfer& transfer, const SmallVector& armature_kg_m2);

/// What turning the rotors takes at the joints, J^T diag(armature) (J q'' + J' q').
SmallVector rotor_torque_Nm(const Transfer& transfer, const SmallVector& armature_kg_m2,
                            const SmallVector& joint_rad_s, const SmallVector& joint_rad_s2);

}  // namespace torquewright::hopper
