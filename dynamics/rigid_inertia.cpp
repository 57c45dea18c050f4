// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rigid_inertia.hpp"

namespace torquewright::dynamics {

RigidInertia moved(const RigidInertia& inertia, const Eigen::Matrix3d& R_AB,
                   const Eigen::Vector3d& p_AB_m) {
  const Eigen::Matrix3d turned = R_AB * inertia.inertia_kg_m2 * R_AB.transpose();
  return {inertia.mass_kg, p_AB_m + R_AB * inertia.center_of_mass_m,
          0.5 * (turned + turned.transpose())};  // rounding must not cost the symmetry
}

RigidInertia welded(const RigidInertia& one, const RigidInertia& other) {
  RigidInertia both;
  both.mass_kg = one.mass_kg + other.mass_kg;
  both.inertia_kg_m2 = one.inertia_kg_m2 + other.inertia_kg_m2;
  if (!(both.mass_kg > 0)) return both;
  both.center_of_mass_m =
      (one.mass_kg * one.center_of_mass_m + other.mass_kg * other.center_of_mass_m) / both.mass_kg;
  const Eigen::Vector3d apart_m = other.center_of_mass_m - one.center_of_mass_m;
  const double reduced_kg = one.mass_kg / both.mass_kg * other.mass_kg;
  both.inertia_kg_m2 += reduced_kg * (apart_m.squaredNorm() * Eigen::Matrix3d::Identity() -
                                      apart_m * apart_m.transpose());
  return both;
}

}  // namespace torquewright::dynamics
