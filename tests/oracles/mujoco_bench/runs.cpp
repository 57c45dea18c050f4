// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
/// Of what is to be seen in the band of 8 Hz.
constexpr double kSlow_hz = 5;

/// Speeds; the higher the frequency the smaller, for the rotor's sake.
Profile draw_speed(Draws& draws, double top, double duration_s) {
  switch (draws.below(5)) {
    case 0:
      return steps(draws, top, draws.uniform(1, 2.5), duration_s);
    case 1:
      return triangle(top, draws.uniform(2, 6));
    case 2:
      return chirp(0.4 * top, 0.1, draws.uniform(1.5, 4), duration_s);
    case 3:
      return sines(draws, top, 0.1, 2, 6);
    default:
      return gait(draws, 0.7 * top, draws.uniform(0.4, 1.2));
  }
}

Profile draw_effort(Draws& draws, double peak, double duration_s, bool fast) {
  if (fast) {
    return draws.chance(0.5) ? chirp(0.6 * peak, 0.3, 15, duration_s)
                             : sines(draws, 0.8 * peak, 0.3, 15, 10);
  }
  switch (draws.below(4)) {
    case 0:
      return steps(draws, 0.8 * peak, draws.uniform(0.5, 2), duration_s);
    case 1:
      return triangle(0.8 * peak, draws.uniform(1.3, 5));
    case 2:
      return chirp(0.6 * peak, 0.2, 6, duration_s);
    default:
      return sines(draws, 0.9 * peak, 0.15, 4, 7);
  }
}

/// Slow enough that ripples of the demanded order lie within the band; else a tenth of the top.
double slow_speed(const Situation& it, const Demand& demand) {
  const double ratio = it.bench.world.motor.ratio;
  const double order = std::max(demand.rotor_order * ratio, demand.output_order);
  const double slow = order > 0 ? kSlow_hz * kTurn_rad / order : 0.06 * it.top_speed_rad_s;
  return std::min(slow, it.top_speed_rad_s);
}

void plan_dynamometer(Situation& it, Draws& draws, const Demand& demand, Recipe& run, bool slow) {
  const double peak = it.bench.world.motor.peak_current_A;
  const double top = slow ? slow_speed(it, demand) : it.top_speed_rad_s * draws.uniform(0.5, 1);
  const bool holds = !slow && draws.chance(0.25);
  if (holds) {
    run.mode = Recipe::Mode::kHeld;
    run.motion = draw_speed(draws, 0.5 * top, run.duration_s);
    run.effort = draw_effort(draws, 0.5 * it.peak_torque_Nm(), run.duration_s, false);
    return;
  }
  run.mode = Recipe::Mode::kImposed;
  run.motion = slow ? steps(draws, top, run.duration_s / 6, run.duration_s)
                    : draw_speed(draws, top, run.duration_s);
  run.effort = draw_effort(draws, peak, run.duration_s, demand.fast_torque);
}

/// Slow swings, wide and narrow, and whole turns where the drive can lift the mass.
void plan_pendulum(Situation& it, Draws& draws, Recipe& run, bool slow) {
  run.mode = Recipe::Mode::kPlaced;
  const double wide = draws.uniform(1, 2.5);
  if (slow)
    run.motion = triangle(draws.uniform(2, 3.1), run.duration_s / 2);
  else if (draws.chance(0.3))
    run.motion = chirp(0.5, 0.2, 1.8, run.duration_s);
  else
    run.motion = sines(draws, wide, 0.1, 0.7, 5);
  run.effort = sines(draws, 0.1 * it.bench.world.motor.peak_current_A, 1, 5, 5);
}

void plan_free(Situation& it, Draws& draws, const Demand& demand, Recipe& run, bool slow) {
  run.mode = Recipe::Mode::kTracked;
  const double top = slow ? slow_speed(it, demand) : it.top_speed_rad_s * draws.uniform(0.5, 1);
  run.motion = slow ? steps(draws, top, run.duration_s / 6, run.duration_s)
                    : draw_speed(draws, top, run.duration_s);
  run.effort = draw_effort(draws, (slow ? 0.03 : 0.25) * it.bench.world.motor.peak_current_A,
                           run.duration_s, demand.fast_torque);
}

/// 2 to 20 runs, mostly 4 to 10, of no more than two minutes in all.
std::pair<int, double> shape(Draws& draws, const Demand& demand) {
  int count = static_cast<int>(4 + draws.below(6));
  if (draws.chance(0.1)) count = static_cast<int>(draws.chance(0.5) ? 2 : 12 + draws.below(9));
  const double whole_s = demand.gentle ? 24 : 84;
  const double longest_s = count == 2 ? 40 : 18;
  return {count, std::clamp(draws.uniform(0.6, 1) * whole_s / count, 3.0, longest_s)};
}

}  // namespace

void draw_runs(Situation& it, Draws& draws, const Demand& demand) {
  const auto [count, mean_s] = shape(draws, demand);
  const std::string type = it.bench.world.load.type;
  const bool by_order = demand.rotor_order > 0 || demand.output_order > 0;
  for (int k = 0; k < count; ++k) {
    Recipe run{.name = fmt::format("run_{}", k + 1)};
    run.duration_s = std::round(10 * mean_s * draws.uniform(0.8, 1.2)) / 10;
    const bool slow = k % (by_order ? 2 : 4) == 1;
    if (type == "dynamometer")
      plan_dynamometer(it, draws, demand, run, slow);
    else if (type == "pendulum")
      plan_pendulum(it, draws, run, slow);
    else
      plan_free(it, draws, demand, run, slow);
    if (it.bench.warms)
      run.start_temperature_K = k % 2 == 0 ? draws.uniform(288, 305) : draws.uniform(320, 360);
    it.bench.recipes.push_back(run);
  }
}

}  // namespace torquewright::oracles::mujoco_bench
