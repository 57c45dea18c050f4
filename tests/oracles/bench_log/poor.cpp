// SPDX-License-Identifier: Apache-2.0
// Data that cannot tell: one effect is true, and others would leave the same residual.
#include <array>
#include <cmath>

#include "tests/oracles/bench_log/draw.hpp"

namespace torquewright::oracles {
namespace {

using Names = std::vector<std::string>;

struct PoorData {
  const char* name;
  Names effects;     ///< One of these is true.
  Names acceptable;  ///< May stand in the group.
  Wishes wishes;
  void (*impoverish)(Bench&, Chance&);
  bool less_torque = false;  ///< A constant that gave more could not be friction: signs would tell.
};

double peak_A(const Bench& bench) { return bench.nominal.peak_current_A; }

Knots mixed_current(const Bench& bench, Chance& chance, std::size_t count) {
  return scaled(multisine(chance, count, 0.15, 2.5, 6), 0.7 * peak_A(bench));
}

/// +-1 in turn, with short edges that are the same for whatever uses them.
Knots to_and_fro(std::size_t count, double hold_s) {
  Knots knots(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = kTick_s * static_cast<double>(k) / (2.0 * hold_s);
    const double wave = 4.0 * std::abs(turn - std::floor(turn) - 0.5) - 1.0;  // A triangle.
    knots[k] = std::tanh(25.0 * wave);
  }
  return knots;
}

void one_speed(Bench& bench, Chance& chance) {
  const double speed = chance.sign() * chance.between(1.5, 4.0);
  for (RunPlan& plan : bench.runs) {
    const std::size_t count = plan.knot_count();
    plan.speed_rad_s = constant(count, speed);
    plan.current_A = mixed_current(bench, chance, count);
  }
}

void one_magnitude(Bench& bench, Chance& chance) {
  const double speed = chance.between(1.5, 4.0);
  for (RunPlan& plan : bench.runs) {
    const std::size_t count = plan.knot_count();
    plan.speed_rad_s = scaled(to_and_fro(count, chance.between(0.8, 2.0)), speed);
    plan.current_A = mixed_current(bench, chance, count);
  }
}

void no_slow_motion(Bench& bench, Chance& chance) {
  for (RunPlan& plan : bench.runs) {
    const std::size_t count = plan.knot_count();
    Knots speed = scaled(to_and_fro(count, chance.between(0.8, 2.0)), chance.between(3.0, 6.0));
    const Knots size = steps(chance, count, 1.5);
    for (std::size_t k = 0; k < count; ++k) speed[k] *= 1.0 + 0.3 * size[k];
    plan.speed_rad_s = speed;
    plan.current_A = mixed_current(bench, chance, count);
  }
}

void constant_load(Bench& bench, Chance& chance) {
  const double current = chance.sign() * chance.between(0.3, 0.6) * peak_A(bench);
  for (RunPlan& plan : bench.runs) plan.current_A = constant(plan.knot_count(), current);
}

void one_temperature(Bench& bench, Chance& chance) {
  // A heavy winding at the temperature of its surroundings: nothing heats, nothing cools.
  const double warm = chance.between(25.0, 50.0);
  for (Machine* machine : {&bench.nominal, &bench.truth}) {
    machine->winding_J_K = rounded(100.0 * machine->winding_J_K);
    machine->case_J_K = rounded(100.0 * machine->case_J_K);
  }
  for (RunPlan& plan : bench.runs) {
    plan.winding_K = plan.case_K = bench.nominal.reference_K + warm;
  }
}

// Speed and current reverse together, one magnitude each, while the winding warms: what follows
// the temperature, the time, the friction or the torque constant is all one.
void warming(Bench& bench, Chance& chance) {
  const double speed = chance.between(1.5, 4.0);
  const double current = 0.5 * peak_A(bench);
  const double hold_s = chance.between(0.8, 2.0);
  for (RunPlan& plan : bench.runs) {
    const Knots way = to_and_fro(plan.knot_count(), hold_s);
    plan.speed_rad_s = scaled(way, speed);
    plan.current_A = scaled(way, current);
    plan.winding_K = plan.case_K = bench.nominal.reference_K;
  }
}

void one_quadrant(Bench& bench, Chance& chance) {
  const double way = chance.sign();
  for (RunPlan& plan : bench.runs) {
    const std::size_t count = plan.knot_count();
    plan.speed_rad_s = scaled(multisine(chance, count, 0.1, 1.0, 4), way * 1.5, way * 2.5);
    plan.current_A = scaled(multisine(chance, count, 0.1, 2.0, 4), way * 0.25 * peak_A(bench),
                            way * 0.4 * peak_A(bench));
  }
}

void one_sinusoid(Bench& bench, Chance& chance) {
  const double frequency = chance.between(0.5, 1.0);
  const double swing = chance.between(0.2, 0.35);
  for (RunPlan& plan : bench.runs) {
    plan.position_rad = scaled(sine(chance, plan.knot_count(), frequency), swing);
    plan.start_rad = plan.position_rad[0];
    plan.start_rad_s = (plan.position_rad[1] - plan.position_rad[0]) / kTick_s;
  }
}

const std::vector<PoorData>& situations() {
  Wishes pendulum;
  pendulum.rig = Load::Type::kPendulum;
  Wishes declared;
  declared.declares_friction = true;
  declared.warm_runs = true;
  Wishes warm;
  warm.warm_runs = true;
  static const std::vector<PoorData> kAll{
      {"one_speed",
       {"coulomb_friction", "viscous_friction", "quadratic_drag"},
       {"coulomb_friction", "viscous_friction", "quadratic_drag", "stribeck_friction",
        "asymmetric_friction", "presliding_friction", "torque_offset", "current_offset"},
       {},
       one_speed},
      {"constant_load",
       {"torque_constant_error", "torque_constant_saturation"},
       {"torque_constant_error", "torque_constant_saturation", "torque_constant_temperature",
        "torque_offset", "current_offset", "asymmetric_friction"},
       {},
       constant_load},
      {"constant_load",
       {"load_dependent_friction"},
       {"load_dependent_friction", "coulomb_friction", "stribeck_friction", "presliding_friction",
        "asymmetric_friction", "torque_constant_error", "torque_offset", "current_offset"},
       {},
       constant_load},
      {"warming",
       {"friction_temperature", "torque_constant_temperature"},
       {"friction_temperature", "torque_constant_temperature"},
       declared,
       warming},
      {"one_temperature",
       {"torque_constant_temperature"},
       {"torque_constant_temperature", "torque_constant_error"},
       warm,
       one_temperature},
      {"one_sinusoid",
       {"load_mass_error"},
       {"load_mass_error", "torque_constant_error", "reflected_inertia", "load_inertia_error",
        "gear_ripple", "gravity_imbalance", "cogging_torque", "torque_constant_saturation",
        "torque_constant_temperature"},
       pendulum,
       one_sinusoid},
      {"no_slow_motion",
       {"coulomb_friction"},
       {"coulomb_friction", "stribeck_friction", "presliding_friction", "asymmetric_friction"},
       {},
       no_slow_motion},
      {"one_magnitude",
       {"viscous_friction", "quadratic_drag", "coulomb_friction"},
       {"viscous_friction", "quadratic_drag", "coulomb_friction", "stribeck_friction",
        "presliding_friction", "asymmetric_friction"},
       {},
       one_magnitude},
      {"one_quadrant",
       {"load_dependent_friction", "torque_constant_error"},
       {"load_dependent_friction", "torque_constant_error", "torque_constant_saturation",
        "torque_constant_temperature"},
       {},
       one_quadrant,
       true},
  };
  return kAll;
}

}  // namespace

Scenario draw_poor(std::uint64_t seed) {
  Chance chance(seed * 8 + static_cast<std::uint64_t>(LogClass::kCannotTell));
  const PoorData& situation = situations()[seed % situations().size()];
  const std::string& effect = chance.one_of(situation.effects);
  Bench bench = draw_bench(situation.wishes, chance);
  situation.impoverish(bench, chance);
  Dial dial = dial_for(effect, bench, chance);
  if (situation.less_torque && effect == "torque_constant_error") {
    dial.set = [](Bench& b, TrueEffect& true_effect, double strength) {
      b.truth.torque_constant_factor = 1.0 - strength;
      true_effect.parameters = {{"factor", b.truth.torque_constant_factor}};
    };
  }
  // What is off by a lot cannot be told either: 5 to 10 floors, so that it is seen for certain.
  const double strength = tune(bench, dial, chance.scale(5.0, kMostMultiple));
  dial.set(bench, dial.effect, strength);
  Truth truth;
  truth.log_class = LogClass::kCannotTell;
  truth.effects = {dial.effect};
  truth.acceptable = situation.acceptable;
  truth.situation = situation.name;
  return make_scenario(bench, std::move(truth), seed, chance);
}

}  // namespace torquewright::oracles
