// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/undecidable.hpp"

#include <algorithm>

#include "tests/oracles/loop_bench/hidden_laws.hpp"

namespace torquewright::oracles::loop {
namespace {

constexpr double kUntilEven_s = 2.0;  ///< Some forty time constants of the loop.
constexpr double kMostOfTurning = 0.6;

/// Waves whose speeds together stay below the turning.
std::vector<Wave> waves_below(double turning_rad_s, Draws& draws) {
  std::vector<Wave> waves(2);
  for (Wave& wave : waves) {
    wave.rate_rad_s = draws.log_uniform(0.8, 5.0);
    wave.amplitude_rad = 0.5 * kMostOfTurning * turning_rad_s / wave.rate_rad_s;
    wave.phase_rad = draws.uniform(-3.0, 3.0);
  }
  return waves;
}

}  // namespace

std::vector<std::string> names_of_one_way() {
  return {"coulomb_friction", "stribeck_friction", "current_offset"};
}

std::vector<std::string> names_of_one_speed() {
  return {"coulomb_friction", "stribeck_friction", "viscous_friction", "quadratic_drag",
          "current_offset"};
}

void draw_undecidable(double scale_Nm, double share_factor, Draws& draws, Situation& it) {
  const bool has_one_speed = it.seed % 2 == 0;
  it.sensing.logs_voltage = false;
  it.rig.drives[0].stated.clear();
  const double turning_rad_s = draws.uniform(4.0, 8.0);
  for (Run& run : it.runs) {
    run.before_s = kUntilEven_s;
    Reference& asked = run.references[0];
    asked = {};
    asked.turning_rad_s = turning_rad_s;
    if (!has_one_speed) asked.waves = waves_below(turning_rad_s, draws);
  }
  const auto names = has_one_speed ? names_of_one_speed() : names_of_one_way();
  const double share = std::min(draws.log_uniform(0.003, 0.25) * share_factor, 0.3);
  hide(draws.one_of(names), share, scale_Nm, draws, it);
  it.accept = {names};
}

}  // namespace torquewright::oracles::loop
