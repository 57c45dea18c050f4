// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tests/oracles/loop_bench/machine.hpp"

namespace torquewright::oracles::loop {

/// What a joint is asked to follow: an even turning, waves, and ramps between rests.
struct Wave {
  double amplitude_rad = 0.0, rate_rad_s = 0.0, phase_rad = 0.0;
};
struct Reference {
  double middle_rad = 0.0;
  double turning_rad_s = 0.0;
  std::vector<Wave> waves;
  double ramp_rad = 0.0, ramp_period_s = 4.0;  ///< There in a quarter, rest, back, rest.
  double at(double time_s) const;
};

struct Run {
  double duration_s = 10.0;
  std::vector<Reference> references;  ///< By joint.
  double before_s = 0.0;              ///< Of it, before the record begins.
};

struct Loop {
  double period_s = 1e-3;
  std::vector<double> stiffness_Nm_rad, damping_Nm_s_rad;  ///< By joint.
};

struct State {
  Pair position_rad{}, speed_rad_s{}, acceleration_rad_s2{}, load_Nm{};
  Pair current_A{};  ///< Of the windings.
  Pair torque_A{};   ///< The current whose torque acts: behind a lag where there is one.
};

inline constexpr double kStep_s = 5e-5;

/// The states at every step. Dry friction by impulses that at most stop the joints
/// (Moreau's scheme), everything else by explicit steps.
std::vector<State> moved(const Rig& rig, const Loop& loop, const Run& run);

}  // namespace torquewright::oracles::loop
