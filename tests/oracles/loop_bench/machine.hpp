// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/oracles/loop_bench/laws.hpp"

namespace torquewright::oracles::loop {

inline constexpr double kGravity_m_s2 = 9.80665;

/// A drive: what its document states, and every law that acts in it, stated or not.
struct Drive {
  double ratio = 10.0;  ///< Motor speed over output speed.
  double torque_constant_Nm_A = 0.1;
  double resistance_ohm = 0.3;
  double rotor_inertia_kg_m2 = 1e-5;
  double bus_V = 48.0, peak_current_A = 20.0;
  std::vector<Law> stated;
  std::vector<Law> hidden;

  std::vector<Law> laws() const;
  double torque_per_current_Nm_A() const { return ratio * torque_constant_Nm_A; }
  double reflected_inertia_kg_m2() const;
};

struct Link {
  double mass_kg = 0.0, length_m = 0.0, center_m = 0.0, inertia_kg_m2 = 0.0;
};

/// One flywheel or pendulum, or two links that hang; positions are relative, 0 hangs down.
struct Rig {
  std::string shape;        ///< flywheel, pendulum, arm or leg.
  std::vector<Link> links;  ///< Of a flywheel one without a mass.
  std::vector<Drive> drives;
  std::size_t joints() const { return drives.size(); }
};

using Pair = std::array<double, 2>;

/// What the links' motion takes: mass matrix and the torques of speeds and weight.
struct LinkTorques {
  double m11 = 0.0, m12 = 0.0, m22 = 1.0;
  Pair bias_Nm{};
};

LinkTorques link_torques(const Rig& rig, const Pair& position_rad, const Pair& speed_rad_s);

}  // namespace torquewright::oracles::loop
