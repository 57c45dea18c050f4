// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "simulation/plant.hpp"
#include "simulation/stepper/plant_motion.hpp"

namespace torquewright::simulation {

/// Computes accelerations of joints and plant from states and drives. `directions` are those of the
/// motors' motion, 0 where friction holds one (docs/derivations/simulation.md section 3). Keeps
/// references to plant and models.
class EquationsOfMotion {
 public:
  EquationsOfMotion(Plant& plant, const std::vector<JointModel>& models);

  /// Returns the motion; `imposed_rad_s2` are accelerations of outputs whose motion is imposed,
  /// null if none is.
  PlantMotion motion(const PlantState& state, const std::vector<double>& directions,
                     const std::vector<DriveNow>& drive, const Eigen::VectorXd* imposed_rad_s2);

  /// Returns the torques on the load with the held joints at rest; of an imposed motion only the
  /// forces.
  PlantMotion held(const PlantState& state, const std::vector<double>& directions,
                   const std::vector<DriveNow>& drive);

  bool is_imposed() const { return plant_.is_imposed(); }
  const std::vector<JointModel>& models() const { return models_; }

 private:
  PlantMotion forces(const PlantState& state, const std::vector<double>& directions,
                     const std::vector<DriveNow>& drive) const;
  void solve(const PlantState& state, const std::vector<double>& directions, PlantMotion& motion);
  void set_plant(const PlantState& state);
  void accelerate(const PlantState& state, const std::vector<double>& directions,
                  const std::vector<bool>& positive, PlantMotion& motion);
  bool correct_sides(const std::vector<double>& directions, const PlantMotion& motion,
                     std::vector<bool>& positive) const;

  Plant& plant_;
  const std::vector<JointModel>& models_;
  Eigen::VectorXd position_, speed_, bias_;
  Eigen::MatrixXd mass_;
  /// Of eq. (3): its matrix, right side and factors, kept for their memory.
  Eigen::MatrixXd left_;
  Eigen::VectorXd right_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace torquewright::simulation
