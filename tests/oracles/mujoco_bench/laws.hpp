// SPDX-License-Identifier: Apache-2.0
// The laws as functions of the state, for the simulation and for the balance alike.
#pragma once

#include "tests/oracles/mujoco_bench/world.hpp"

namespace torquewright::oracles::mujoco_bench {

/// Sum of A sin(order angle + phase).
double sum_of(const std::vector<Harmonic>& harmonics, double angle_rad);

/// Torque constant over its stated value, at this temperature.
double magnet_factor(const World& world, double temperature_K);

double resistance_ohm(const World& world, double temperature_K);

/// Electromagnetic torque at the output, before any loss; without lag.
double motor_torque_Nm(const World& world, double current_A, double temperature_K);

/// What the drag depends on.
struct Sliding {
  double speed_rad_s, position_rad, current_A, temperature_K, load_Nm, time_s;
};

/// Magnitude of the drag while sliding forwards (+1) or backwards (-1), without the mesh's loss and
/// without presliding.
double drag_Nm(const World& world, const Sliding& state, double direction);

/// Torque before the mesh over torque behind it, while sliding in `direction`.
double mesh_gain(const World& world, double mesh_torque_Nm, double direction);

/// The Dahl force after a small displacement: dF/dx = stiffness (1 - F/level sgn(dx)), solved
/// exactly.
double dahl_Nm(double force_Nm, double displacement_rad, double level_Nm, double stiffness_Nm_rad);

/// What acts on the flange from outside the gears: ripple, imbalance (not springs and stops).
double flange_torque_Nm(const World& world, double position_rad);

/// 1 + the sum of the harmonics in proportion to the load.
double load_ripple_factor(const World& world, double position_rad);

}  // namespace torquewright::oracles::mujoco_bench
