// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::simulation {

class JointModel;
struct PlantMotion;
struct PlantState;

/// Work since the start, of all joints, in J. Put in less lost is stored, to the scheme's order.
struct WorkAccount {
  double motor_J = 0.0;     ///< Put in by the motors' torque.
  double load_J = 0.0;      ///< Put in by what imposes the motion.
  double periodic_J = 0.0;  ///< Put in by cogging and ripple.
  double friction_J = 0.0;  ///< Taken by friction (what bristles store included).
  double mesh_J = 0.0;      ///< Taken by the gears.
  double damper_J = 0.0;    ///< Taken by what damps a twist.
  double stored_J = 0.0;    ///< In motion, height and twist: gained.

  /// Adds that of a step whose middle is `middle`, with the motion there.
  void add(const PlantState& middle, const PlantMotion& motion,
           const std::vector<JointModel>& models, bool is_imposed, double step_s);
};

}  // namespace torquewright::simulation
