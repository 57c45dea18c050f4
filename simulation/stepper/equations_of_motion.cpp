// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepper/equations_of_motion.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace torquewright::simulation {

EquationsOfMotion::EquationsOfMotion(Plant& plant, const std::vector<JointModel>& models)
    : plant_(plant),
      models_(models),
      position_(plant.joint_count()),
      speed_(plant.joint_count()),
      bias_(plant.joint_count()),
      mass_(plant.joint_count(), plant.joint_count()) {}

void EquationsOfMotion::set_plant(const PlantState& state) {
  for (std::size_t j = 0; j < state.joints.size(); ++j) {
    position_[static_cast<Eigen::Index>(j)] = state.joints[j].position_rad;
    speed_[static_cast<Eigen::Index>(j)] = state.joints[j].speed_rad_s;
  }
  plant_.bias(position_, speed_, bias_);
  plant_.mass_matrix(position_, mass_);
}

/// Eq. (3) for gears that carry positive torque or not, as stated.
void EquationsOfMotion::accelerate(const PlantState& state, const std::vector<double>& directions,
                                   const std::vector<bool>& positive, PlantMotion& motion) {
  const Eigen::Index joints = plant_.joint_count();
  left_ = mass_;
  right_ = -bias_;
  for (Eigen::Index j = 0; j < joints; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const JointModel& model = models_[index];
    const JointForces& forces = motion.forces[index];
    if (model.is_elastic()) {
      const double twist_Nm = model.twist(state.joints[index]).torque_Nm;
      right_[j] += twist_Nm * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
      continue;
    }
    if (directions[index] == 0.0) {
      left_.row(j).setZero();
      left_(j, j) = 1.0;
      right_[j] = 0.0;
      continue;
    }
    const double gain = forces.gain(positive[index]) * (1.0 + forces.ripple_ratio);
    // A gear that locks takes any torque: what is before it balances. Large stands for infinite.
    const double slope = std::isfinite(gain) ? gain : 1e9;
    left_(j, j) += slope * model.inertia_kg_m2();
    right_[j] += slope * forces.before_mesh_Nm + forces.ripple_Nm;
  }
  if (joints == 1) {
    motion.acceleration_rad_s2 = right_ / left_(0, 0);
  } else {
    factors_.compute(left_);
    motion.acceleration_rad_s2 = factors_.solve(right_);
  }
}

/// Whether those accelerations agree with the sides that they were found for; else other sides.
bool EquationsOfMotion::correct_sides(const std::vector<double>& directions,
                                      const PlantMotion& motion,
                                      std::vector<bool>& positive) const {
  bool agrees = true;
  for (std::size_t j = 0; j < positive.size(); ++j) {
    if (models_[j].is_elastic() || directions[j] == 0.0) continue;
    const double net =
        motion.forces[j].before_mesh_Nm -
        models_[j].inertia_kg_m2() * motion.acceleration_rad_s2[static_cast<Eigen::Index>(j)];
    if ((net > 0.0) == positive[j]) continue;
    positive[j] = !positive[j];
    agrees = false;
  }
  return agrees;
}

void EquationsOfMotion::solve(const PlantState& state, const std::vector<double>& directions,
                              PlantMotion& motion) {
  set_plant(state);
  // Through the gear the torque on the load is monotone and piecewise linear in the acceleration:
  // guess each gear's side, solve, correct the guess.
  std::vector<bool> positive(state.joints.size());
  for (std::size_t j = 0; j < positive.size(); ++j)
    positive[j] = motion.forces[j].before_mesh_Nm > 0.0;
  for (Eigen::Index round = 0; round < 2 * plant_.joint_count() + 2; ++round) {
    accelerate(state, directions, positive, motion);
    if (correct_sides(directions, motion, positive)) break;
  }
  motion.torque_Nm = mass_ * motion.acceleration_rad_s2 + bias_;
}

PlantMotion EquationsOfMotion::forces(const PlantState& state,
                                      const std::vector<double>& directions,
                                      const std::vector<DriveNow>& drive) const {
  PlantMotion motion;
  motion.forces.reserve(models_.size());
  for (std::size_t j = 0; j < models_.size(); ++j) {
    motion.forces.push_back(models_[j].forces(state.joints[j], directions[j], drive[j]));
  }
  return motion;
}

PlantMotion EquationsOfMotion::held(const PlantState& state, const std::vector<double>& directions,
                                    const std::vector<DriveNow>& drive) {
  PlantMotion motion = forces(state, directions, drive);
  if (!plant_.is_imposed()) solve(state, directions, motion);
  return motion;
}

PlantMotion EquationsOfMotion::motion(const PlantState& state,
                                      const std::vector<double>& directions,
                                      const std::vector<DriveNow>& drive,
                                      const Eigen::VectorXd* imposed_rad_s2) {
  PlantMotion motion = forces(state, directions, drive);
  if (imposed_rad_s2 == nullptr) {
    solve(state, directions, motion);
  } else {
    motion.acceleration_rad_s2 = *imposed_rad_s2;
    motion.torque_Nm.resize(imposed_rad_s2->size());
  }
  motion.motor_acceleration_rad_s2 = motion.acceleration_rad_s2;
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const JointForces& forces = motion.forces[j];
    const double inertia = models_[j].inertia_kg_m2();
    if (models_[j].is_elastic()) {
      const double twist_Nm = models_[j].twist(state.joints[j]).torque_Nm;
      const double carried_Nm = models_[j].carried_Nm(twist_Nm, directions[j]);
      motion.motor_acceleration_rad_s2[row] =
          directions[j] == 0.0 ? 0.0 : (forces.before_mesh_Nm - carried_Nm) / inertia;
      if (imposed_rad_s2 != nullptr) {
        motion.torque_Nm[row] = twist_Nm * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
      }
    } else if (imposed_rad_s2 != nullptr) {
      const double net = forces.before_mesh_Nm - inertia * (*imposed_rad_s2)[row];
      motion.torque_Nm[row] =
          net * forces.gain(net > 0.0) * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
    }
  }
  return motion;
}

}  // namespace torquewright::simulation
