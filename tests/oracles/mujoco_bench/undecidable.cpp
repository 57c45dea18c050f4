// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/undecidable.hpp"

#include <algorithm>

namespace torquewright::oracles::mujoco_bench {
namespace {

/// Larger, and what is left of other speeds, loads, and angles would tell the names apart.
constexpr SizeRange kModest = {1, 15};
const Demand kPlainBench = {.loads = {"dynamometer"}, .drive = "current"};

/// One way to play too little, the names that would all do, and those of them that are drawn.
struct Poor {
  const char* note;
  Demand demand;
  void (*impoverish)(Situation& it, Draws& draws);
  std::vector<std::string> names, drawn;
};

void begin_moving(Recipe& run, const Profile& motion) {
  run.mode = Recipe::Mode::kImposed;
  run.motion = motion;
  run.begins_moving = true;
}

/// So heavy a machine that no torque of the drive changes its speed.
void one_speed(Situation& it, Draws& draws) {
  it.bench.inertia_kg_m2 *= 100;
  const double speed = draws.sign() * draws.uniform(0.2, 1) * it.top_speed_rad_s;
  for (Recipe& run : it.bench.recipes) {
    if (run.mode == Recipe::Mode::kHeld)
      run.effort = sines(draws, 0.7 * it.stated.motor.peak_current_A, 0.2, 3, 6);
    begin_moving(run, constant(speed));
  }
}

void one_load(Situation& it, Draws& draws) {
  const double current = draws.sign() * draws.uniform(0.3, 0.8) * it.stated.motor.peak_current_A;
  for (Recipe& run : it.bench.recipes) {
    if (run.mode == Recipe::Mode::kHeld) run.motion = sines(draws, it.top_speed_rad_s, 0.1, 1.5, 6);
    begin_moving(run, run.motion);
    run.effort = constant(current);
  }
}

void one_temperature(Situation& it, Draws& draws) {
  const double temperature_K = draws.uniform(325, 360);
  it.bench.warms = false;
  for (Recipe& run : it.bench.recipes) run.start_temperature_K = temperature_K;
}

void one_sine(Situation& it, Draws& draws) {
  Profile sine = sines(draws, draws.uniform(0.08, 0.15), 0.8, 1.5, 1);
  sine.sines[0].phase_rad = 0;
  for (Recipe& run : it.bench.recipes) {
    run.motion = sine;
    run.effort = constant(0);
  }
}

/// Torque and speed of one sign throughout.
void driving_only(Situation& it, Draws& draws) {
  double sign = 1;
  for (Recipe& run : it.bench.recipes) {
    Profile motion = triangle(0.4 * it.top_speed_rad_s, draws.uniform(3, 6));
    motion.offset = 0.5 * sign * it.top_speed_rad_s;
    Profile effort = sines(draws, 0.35 * it.stated.motor.peak_current_A, 0.2, 2, 5);
    effort.offset = 0.5 * sign * it.stated.motor.peak_current_A;
    begin_moving(run, motion);
    run.effort = effort;
    sign = -sign;
  }
}

const std::vector<Poor>& poor_kinds() {
  static const std::vector<std::string> kOneSpeed = {
      "coulomb_friction",    "viscous_friction", "quadratic_drag", "stribeck_friction",
      "asymmetric_friction", "torque_offset",    "current_offset", "presliding_friction"};
  static const std::vector<std::string> kOneLoad = {"torque_constant_error",
                                                    "torque_constant_saturation", "torque_offset",
                                                    "current_offset", "asymmetric_friction"};
  static const std::vector<std::string> kInPhase = {"load_mass_error",   "load_inertia_error",
                                                    "reflected_inertia", "torque_constant_error",
                                                    "gravity_imbalance", "gear_ripple"};
  static const std::vector<Poor> kinds = {
      {"one speed and one direction: what each kind of friction and an offset do is one constant",
       kPlainBench,
       one_speed,
       kOneSpeed,
       {"coulomb_friction", "viscous_friction", "quadratic_drag", "torque_offset"}},
      {"one current throughout: a factor and an offset are the same",
       kPlainBench,
       one_load,
       kOneLoad,
       {"torque_constant_error", "torque_constant_saturation", "torque_offset"}},
      {"one temperature, away from the reference",
       {.loads = {"dynamometer"}, .temperature = true, .drive = "current"},
       one_temperature,
       {"torque_constant_temperature", "torque_constant_error"},
       {"torque_constant_temperature"}},
      {"one small sine on a pendulum: all that acts in phase with the angle is one number",
       {.loads = {"pendulum"}, .drive = "current"},
       one_sine,
       kInPhase,
       {"load_mass_error", "reflected_inertia", "torque_constant_error"}},
      {"driving only: friction in proportion to load is a factor on the torque constant",
       kPlainBench,
       driving_only,
       {"load_dependent_friction", "torque_constant_error"},
       {"load_dependent_friction"}},
  };
  return kinds;
}

}  // namespace

std::optional<Made> draw_undecidable(Draws& draws, std::uint64_t turn) {
  const Poor& poor = poor_kinds()[turn % poor_kinds().size()];
  const std::string name = draws.one_of(poor.drawn);
  const Draws own(draws.next());
  Situation it = draw_rig(draws, poor.demand);
  if (!poor.demand.temperature && it.format.has("winding_temperature_K")) return std::nullopt;
  // Losses of the mesh would tell loads and directions apart.
  it.bench.world.motor.forward_efficiency = it.bench.world.motor.backward_efficiency = 1;
  it.stated = it.bench.world;
  poor.impoverish(it, draws);
  it.note = poor.note;
  const auto by_scale = [&](double scale) { return make_effect(name, scale, it, own); };
  auto made = complete(it, {by_scale}, draws, kModest);
  if (made) made->situation.accept = {poor.names};
  return made;
}

}  // namespace torquewright::oracles::mujoco_bench
