// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::simulation {

class JointModel;
struct PlantMotion;
struct PlantState;

/// Work of all joints since the start, in J. What is put in, less what is lost, is stored, to the
/// order of the scheme.
struct WorkAccount {
  double motor_J = 0.0;     ///< Work put in by the motors' torque.
  double load_J = 0.0;      ///< Work put in by what imposes the motion.
  double periodic_J = 0.0;  ///< Work put in by cogging and ripple.
  double friction_J = 0.0;  ///< Work lost to friction, including what bristles store.
  double mesh_J = 0.0;      ///< Work lost in the gears.
  double damper_J = 0.0;    ///< Work lost in the damping of a twist.
  double stored_J = 0.0;    ///< Energy gained in motion, height and twist.

  /// Adds the work of a step whose middle is `middle`, with the motion there.
  void add(const PlantState& middle, const PlantMotion& motion,
           const std::vector<JointModel>& models, bool is_imposed, double step_s);
};

}  // namespace torquewright::simulation
