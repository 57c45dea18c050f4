// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/geared_torque.hpp"

#include <cmath>

#include "actuator/region/torque_at.hpp"

namespace torquewright::actuator {
namespace {

/// Of the torque: what rounding leaves of no acceleration must not choose a direction at rest.
constexpr double kNoAcceleration = 1e-9;

}  // namespace

RotorBeforeMesh::RotorBeforeMesh(const Actuator& actuator)
    : rotor_kg_m2_(before_gears_kg_m2(actuator)),
      driving_(after_mesh_Nm(actuator, 1.0, 1.0)),
      driven_(after_mesh_Nm(actuator, 1.0, -1.0)) {}

GearedTorque RotorBeforeMesh::of(double speed_rad_s, double torque_Nm, double acceleration_rad_s2,
                                 double before_rad_s) const {
  const double rotor_Nm = rotor_kg_m2_ * acceleration_rad_s2;
  const double teeth_Nm = torque_Nm - rotor_Nm;
  const bool accelerates = std::abs(rotor_Nm) > kNoAcceleration * std::abs(torque_Nm);
  if (!accelerates || !std::isfinite(driven_)) return {torque_Nm, teeth_Nm};
  double direction = acceleration_rad_s2;
  if (before_rad_s != 0.0) direction = before_rad_s;
  if (speed_rad_s != 0.0) direction = speed_rad_s;
  const double before_Nm = teeth_Nm / factor(teeth_Nm, direction) + rotor_Nm;
  // The region at rest is asked what can be held, for which the mesh helps.
  const double asked = speed_rad_s == 0.0 ? -before_Nm : speed_rad_s;
  return {before_Nm * factor(before_Nm, asked), teeth_Nm};
}

Actuator RotorBeforeMesh::behind_any_teeth(Actuator actuator) const {
  if (std::isfinite(driven_)) actuator.transmission.peak_torque_Nm = kUnlimited;
  return actuator;
}

}  // namespace torquewright::actuator
