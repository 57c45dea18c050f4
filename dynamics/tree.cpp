// SPDX-License-Identifier: Apache-2.0
#include "dynamics/tree.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

namespace torquewright::dynamics {
namespace {

constexpr double kUnit = 1e-9;  // how far a unit vector or a rotation may be from one

Eigen::Index joints_of(const Tree& tree) {
  return static_cast<Eigen::Index>(tree.bodies.size()) - 1;
}

bool is_finite(const Body& body) {
  const auto& [name, parent, joint, inertia] = body;
  return std::isfinite(inertia.mass_kg) && inertia.center_of_mass_m.allFinite() &&
         inertia.inertia_kg_m2.allFinite() && joint.R_PB.allFinite() && joint.p_PB_m.allFinite() &&
         joint.axis.allFinite() && std::isfinite(joint.reflected_inertia) &&
         joint.rotor_spin_kg_m2.allFinite();
}

bool is_valid(const PassiveForces& passive) {
  for (const double number :
       {passive.damping, passive.dry_friction, passive.static_friction, passive.stiffness}) {
    if (!std::isfinite(number) || number < 0) return false;
  }
  return std::isfinite(passive.rest_position);
}

const char* fault_of(const Body& body, std::size_t index) {
  const Joint& joint = body.joint;
  if (!is_finite(body)) return "has a number that is not finite";
  if (index > 0 && body.parent >= index) return "does not come after its parent";
  if (body.inertia.mass_kg < 0) return "has a negative mass";
  if (joint.reflected_inertia < 0) return "has a negative reflected inertia";
  if (!is_valid(joint.passive)) return "has passive forces that are negative or not finite";
  const Eigen::Matrix3d& inertia = body.inertia.inertia_kg_m2;
  if (inertia != inertia.transpose()) return "has an inertia that is not symmetric";
  const Eigen::Matrix3d square = joint.R_PB * joint.R_PB.transpose();
  if (!square.isIdentity(kUnit) || joint.R_PB.determinant() < 0) return "has no rotation as R_PB";
  if (std::abs(joint.axis.norm() - 1) > kUnit) return "has an axis that is not a unit vector";
  return nullptr;
}

}  // namespace

Eigen::Index Tree::base_velocity_size() const {
  return base == BaseKind::kFixed ? 0 : (base == BaseKind::kPlanar ? 3 : 6);
}

Eigen::Index Tree::velocity_size() const { return base_velocity_size() + joints_of(*this); }

Eigen::Index Tree::position_size() const {
  return velocity_size() + (base == BaseKind::kSpatial ? 1 : 0);
}

void require_tree(const Tree& tree) {
  if (tree.bodies.empty()) throw std::invalid_argument("tree: no bodies, not even a base");
  if (!std::isfinite(tree.gravity_m_s2)) throw std::invalid_argument("tree: gravity not finite");
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const char* fault = fault_of(tree.bodies[i], i);
    if (fault != nullptr) {
      throw std::invalid_argument("tree: body " + tree.bodies[i].name + " " + fault);
    }
  }
}

}  // namespace torquewright::dynamics
