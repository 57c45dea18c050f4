// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "tests/oracles/mujoco_bench/world.hpp"

namespace torquewright::oracles::mujoco_bench {

constexpr double kGravity_m_s2 = 9.81;

/// What is imposed for one step.
struct Drive {
  /// At the output, before friction and mesh: motor, cogging, less presliding friction.
  double motor_torque_Nm = 0;
  /// Of the machine behind the torque sensor.
  double bench_torque_Nm = 0;
  double current_A = 0, temperature_K = 298.15, time_s = 0;
};

/// At the beginning of the step.
struct Motion {
  double position_rad = 0, speed_rad_s = 0, acceleration_rad_s2 = 0;
  /// The rotor's, over the ratio: the same unless the gear is elastic.
  double rotor_position_rad = 0, rotor_speed_rad_s = 0;
  double load_torque_Nm = 0;
};

/// Of the flanks of a gear with play, at the output: the plant has it beside its gap.
double flank_stiffness_Nm_rad(const World& world);

/// Rotor, gear, and load as MuJoCo's bodies: one joint with the rotor as its armature, or, with
/// play or compliance, two joints and a tendon that is a spring, its rest moved through the gap.
///
/// Dry friction is not MuJoCo's frictionloss: that is a soft constraint, which creeps. Each step
/// chooses the branch of the exact law (forwards, backwards, at rest) that agrees with itself, and
/// applies its torque; gravity, springs, stops, and the integration are MuJoCo's.
class Plant {
 public:
  /// `bench_inertia_kg_m2` turns with the output, behind the sensor.
  Plant(const World& world, double bench_inertia_kg_m2, double payload_share, double step_s);

  Motion step(const Drive& drive);
  Motion motion() const;
  void set_speed(double speed_rad_s);
  double total_inertia_kg_m2() const { return armature_kg_m2_ + load_inertia_kg_m2_; }
  double step_s() const { return model_->opt.timestep; }

 private:
  double slip_acceleration(const Drive& drive, double mesh_slope, double mesh_level) const;
  double slide(const Drive& drive, double mesh_slope, double mesh_level, double direction) const;
  void apply_rigid(const Drive& drive);
  void apply_elastic(const Drive& drive);
  void follow_gap();

  World world_;
  double armature_kg_m2_, load_inertia_kg_m2_;
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_{nullptr, mj_deleteData};
  int output_ = 0;
  double mesh_torque_Nm_ = 0;
};

}  // namespace torquewright::oracles::mujoco_bench
