// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "dynamics/gravity.hpp"

namespace torquewright::dynamics {

/// Mass, centre of mass and inertia, in the axes of the body that they belong to.
struct RigidInertia {
  double mass_kg = 0;
  Eigen::Vector3d center_of_mass_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_kg_m2 =
      Eigen::Matrix3d::Zero();  ///< Inertia about the centre of mass; symmetric.
};

enum class JointKind { kRevolute, kPrismatic };

/// Limits of a joint, in rad and Nm for revolute joints, in m and N for prismatic ones. Magnitudes,
/// but for positions.
struct JointLimits {
  double position_min = -std::numeric_limits<double>::infinity();
  double position_max = std::numeric_limits<double>::infinity();
  double speed_max = std::numeric_limits<double>::infinity();
  double effort_max = std::numeric_limits<double>::infinity();
  /// Whether these two are the joint's own (bearings, cables) and not those of what drives it: then
  /// they stay with another gear ratio.
  bool owns_speed = false, owns_effort = false;
};

/// What a joint does by itself, whoever drives it: bearings, seals, cables, springs. In Nm per rad
/// for revolute joints, in N per m for prismatic ones; none of the numbers but rest_position is
/// negative.
struct PassiveForces {
  double damping = 0;          ///< Force against motion per speed: N m s/rad or N s/m.
  double dry_friction = 0;     ///< Force against motion at any speed: N m or N.
  double static_friction = 0;  ///< The most that it holds at rest, no less than dry_friction.
  double stiffness = 0;        ///< Force of a spring per position away from rest_position.
  double rest_position = 0;    ///< Position at which the spring gives no force, in rad or m.

  bool is_none() const {
    return damping == 0 && dry_friction == 0 && static_friction == 0 && stiffness == 0;
  }
};

/// How a body is carried by its parent. The body's frame B sits at the joint; at position zero it
/// stands in the parent's frame P as R_PB and p_PB_m say.
struct Joint {
  std::string name = {};
  JointKind kind = JointKind::kRevolute;
  Eigen::Matrix3d R_PB = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_PB_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  ///< Unit vector of the axis in B.
  JointLimits limits;
  PassiveForces passive;
  /// Inertia of the rotor as it reflects at the joint, N^2 J (kg m2; kg for prismatic joints).
  double reflected_inertia = 0;
  /// The rotor's own spin: its inertia times rotor speed over joint speed, N J, along its axis in
  /// the parent, which carries it. Zero leaves the rotor's angular momentum out of the dynamics
  /// and of all momenta, as models with reflected inertia alone do
  /// (docs/derivations/rigid_body.md, "Rotors").
  Eigen::Vector3d rotor_spin_kg_m2 = Eigen::Vector3d::Zero();
};

struct Body {
  std::string name;
  std::size_t parent = 0;  ///< Index of the parent in the tree; meaningless for the base.
  /// The joint that carries the body; of the base only R_PB and p_PB_m, and only if it is fixed.
  Joint joint;
  RigidInertia inertia;
};

enum class BaseKind {
  kFixed,   ///< Stands where joint.R_PB, joint.p_PB_m of body 0 put it in the world.
  kPlanar,  ///< Moves in the plane of x and z: position x, z, pitch about +y; velocity their rates.
  kSpatial,  ///< Position x, y, z, then the quaternion w, x, y, z of R_WB; velocity of the origin
             ///< in the world's axes, then angular velocity in the base's own.
};

/// Bodies, parents before children; the first is the base.
struct Tree {
  BaseKind base = BaseKind::kFixed;
  std::vector<Body> bodies;
  double gravity_m_s2 = kGravity_m_s2;  ///< Gravity, along -z of the world.

  /// Number of elements of a position: the base's first, then one per joint in the order of the
  /// bodies.
  Eigen::Index position_size() const;
  Eigen::Index velocity_size() const;
  Eigen::Index base_velocity_size() const;
};

/// Throws std::invalid_argument, naming the body, where the tree is not valid: no base, a parent
/// that does not come before its child, an axis that is not a unit vector, an invalid rotation, a
/// negative mass, numbers that are not finite. Whether inertias are those of real bodies is for the
/// reader of documents to check: massless bodies between two joints are needed and allowed.
void require_tree(const Tree& tree);

}  // namespace torquewright::dynamics
