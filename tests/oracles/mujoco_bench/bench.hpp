// SPDX-License-Identifier: Apache-2.0
// The bench: what is played, what the drive does about it, and what happens.
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/profile.hpp"
#include "tests/oracles/mujoco_bench/world.hpp"

namespace torquewright::oracles::mujoco_bench {

/// Of one run.
struct Recipe {
  enum class Mode {
    kImposed,  ///< The bench imposes `motion` as a speed, the drive plays `effort` as a current.
    kHeld,     ///< The drive follows `motion` as a speed, the bench plays `effort` as a torque.
    kTracked,  ///< The drive follows `motion` as a speed and adds `effort` as a current.
    kPlaced,   ///< As kTracked, `motion` being a position.
  };
  std::string name;
  Mode mode = Mode::kImposed;
  double duration_s = 10;
  Profile motion = {}, effort = {};
  double start_temperature_K = 298.15;
  /// What is played is there from the first sample on, instead of rising from nothing.
  bool begins_moving = false;
};

/// Samples of what is true, kRecord_s apart.
struct Record {
  std::string name;
  std::size_t index = 0;
  std::vector<double> time_s, position_rad, speed_rad_s, acceleration_rad_s2, rotor_rad, current_A,
      torque_Nm, temperature_K, duty, bus_V;
};

constexpr double kRecord_s = 1e-3;

struct Bench {
  World world;
  bool voltage_driven = false;
  bool warms = false;
  double inertia_kg_m2 = 1;  ///< Of the machine behind the torque sensor.
  double bandwidth_hz = 3;   ///< Of the drive where it follows a motion.
  double heating_K_s_A2 = 0, cooling_s = 200;
  std::vector<Recipe> recipes;
};

std::vector<Record> play(const Bench& bench);

}  // namespace torquewright::oracles::mujoco_bench
