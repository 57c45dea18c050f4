// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::hopper {

/// A mechanism joins as many actuators as joints, at most this many.
constexpr int kMostJoints = 2;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostJoints, 1>;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostJoints, kMostJoints>;

/// How actuators move with the joints, at one posture and speed. No power is lost between them, so
/// that joint torques are the transposed Jacobian times the actuators' torques. k actuators on k
/// joints; docs/derivations/mechanisms.md eq. (1).
struct Transfer {
  SmallVector actuator_position_rad;  ///< (k x 1), of each actuator's output, behind its gearbox.
  SmallMatrix jacobian;               ///< (k x k), actuators' speeds over joints' speeds.
  SmallMatrix jacobian_rate_1_s;      ///< Its rate while the joints move so.
};

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

  /// As documents name it.
  virtual std::string_view type() const = 0;
  /// Joints, and as many actuators.
  virtual Eigen::Index size() const = 0;
  /// Empty where the linkage does not reach the posture, or is singular there.
  virtual std::optional<Transfer> transfer(const SmallVector& joint_rad,
                                           const SmallVector& joint_rad_s) const = 0;
  /// At a posture; empty: nothing limits it but the joints.
  virtual std::vector<MechanismMargin> margins(const SmallVector& joint_rad) const;
  /// Where it is the same in every posture.
  virtual std::optional<SmallMatrix> constant_jacobian() const { return std::nullopt; }
};

/// J^T torques of the actuators, eq. (2).
SmallVector joint_torque_Nm(const Transfer& transfer, const SmallVector& actuator_Nm);

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
