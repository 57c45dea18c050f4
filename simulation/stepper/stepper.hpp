// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/stepper/equations_of_motion.hpp"
#include "simulation/stepper/work_account.hpp"

namespace torquewright::simulation {

/// State of an imposed motion in the middle and at the end of a step.
struct ImposedStep {
  double middle_position_rad = 0.0, middle_speed_rad_s = 0.0, middle_acceleration_rad_s2 = 0.0;
  double end_position_rad = 0.0, end_speed_rad_s = 0.0;
};

/// Moves the joints of a plant through time (docs/derivations/simulation.md section 3). Keeps
/// references to plant and models.
class Stepper {
 public:
  Stepper(Plant& plant, const std::vector<JointModel>& models) : equations_(plant, models) {}

  EquationsOfMotion& equations() { return equations_; }

  /// Advances by one step in which everything with a rate of its own is held; joints may stop and
  /// start within it.
  void advance(PlantState& state, const std::vector<DriveNow>& drive, double step_s,
               WorkAccount& work);

  /// Advances by one step of an imposed motion of the output: only the motor of an elastic train is
  /// integrated. Returns the torque on what imposes the motion, in the middle of the step.
  double advance_imposed(PlantState& state, const std::vector<DriveNow>& drive, double step_s,
                         const ImposedStep& imposed, WorkAccount& work);

 private:
  /// Middle and end of a step of the midpoint rule.
  struct Part {
    PlantState middle, end;
    PlantMotion motion;  ///< Motion in the middle.
  };
  void midpoint(const PlantState& from, const std::vector<double>& directions,
                const std::vector<DriveNow>& drive, double step_s, Part& part);
  double advance_rigid_imposed(PlantState& state, const std::vector<DriveNow>& drive, double step_s,
                               const ImposedStep& imposed, WorkAccount& work);
  void add_work(const PlantState& middle, const PlantMotion& motion, double step_s,
                WorkAccount& work) const;

  EquationsOfMotion equations_;
  Part part_;  ///< The present one, kept for its memory.
};

}  // namespace torquewright::simulation
