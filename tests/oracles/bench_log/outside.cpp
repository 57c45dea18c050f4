// SPDX-License-Identifier: Apache-2.0
// What no effect of the library is: an honest report names the coordinate and no effect.
#include <array>
#include <cmath>

#include "tests/oracles/bench_log/draw.hpp"

namespace torquewright::oracles {
namespace {

struct Phenomenon {
  const char* name;
  std::vector<std::string> coordinates;  ///< Any of these is right.
  double least, most;                    ///< Strength, as a share of the peak torque or current.
  double speed;                          ///< Times the usual speed: slow where ripple is shown.
  void (*set)(Bench&, double strength, Chance&);
};

void grow(Bench& bench, double strength, Chance&) {
  bench.truth.outside.friction_growth_Nm_s = strength * peak_torque_Nm(bench.nominal) / 15.0;
}

void tighten(Bench& bench, double strength, Chance& chance) {
  Outside& outside = bench.truth.outside;
  outside.tight_spot_rad = chance.between(-1.0, 1.0);
  outside.tight_spot_width_rad = chance.between(0.3, 0.8);
  outside.tight_spot_Nm = strength * peak_torque_Nm(bench.nominal);
}

void deaden(Bench& bench, double strength, Chance&) {
  bench.faults.current_dead_zone_A = strength * bench.nominal.peak_current_A;
}

void commutate(Bench& bench, double strength, Chance& chance) {
  bench.truth.outside.commutation_ratio = strength;
  bench.truth.outside.commutation_phase_rad = chance.phase();
}

void lag_behind(Bench& bench, double strength, Chance& chance) {
  const double peak = peak_torque_Nm(bench.nominal);
  bench.faults.hysteresis_Nm = strength * peak;
  bench.faults.hysteresis_span_Nm = chance.between(0.1, 0.25) * peak;
}

void fade(Bench& bench, double strength, Chance& chance) {
  const std::array<double, 3> orders{4.0, 6.0, 7.0};
  bench.truth.cogging.terms = {
      {chance.one_of(orders), strength * peak_torque_Nm(bench.nominal), chance.phase()}};
  bench.truth.outside.cogging_fade_rad_s = chance.between(0.15, 0.4);
}

void favour(Bench& bench, double strength, Chance&) {
  bench.faults.current_negative_gain = 1.0 + strength;
}

void grease(Bench& bench, double strength, Chance& chance) {
  bench.truth.outside.grease_Nm = strength * peak_torque_Nm(bench.nominal);
  bench.truth.outside.grease_s = chance.between(0.15, 0.5);
}

const std::array<Phenomenon, 8>& phenomena() {
  static const std::array<Phenomenon, 8> kAll{{
      {"friction_growing_with_time", {"time_s"}, 0.002, 0.2, 1.0, grow},
      {"tight_spot", {"output_position_rad", "motor_position_rad"}, 0.002, 0.3, 0.6, tighten},
      {"current_sensor_dead_zone",
       {"motor_current_A", "output_torque_Nm"},
       0.002,
       0.1,
       1.0,
       deaden},
      {"commutation_ripple",
       {"electrical_angle", "motor_position_rad", "output_position_rad"},
       0.002,
       0.2,
       0.05,
       commutate},
      {"torque_sensor_hysteresis",
       {"output_torque_Nm", "motor_current_A"},
       0.001,
       0.1,
       1.0,
       lag_behind},
      {"cogging_fading_with_speed",
       {"motor_position_rad", "output_velocity_rad_s", "electrical_angle"},
       0.002,
       0.3,
       0.15,
       fade},
      {"one_sided_current_gain", {"motor_current_A", "output_torque_Nm"}, 0.002, 0.2, 1.0, favour},
      {"friction_after_reversal", {"time_since_reversal"}, 0.002, 0.3, 1.0, grease},
  }};
  return kAll;
}

Dial dial_of(const Phenomenon& phenomenon, std::uint64_t details) {
  Dial dial;
  dial.effect.effect = phenomenon.name;
  dial.least = phenomenon.least;
  dial.most = phenomenon.most;
  dial.start = std::sqrt(dial.least * dial.most);
  // The details are drawn anew at every turn of the dial, always the same ones.
  dial.set = [&phenomenon, details](Bench& bench, TrueEffect&, double strength) {
    Chance chance(details);
    phenomenon.set(bench, strength, chance);
  };
  return dial;
}

}  // namespace

Scenario draw_outside(std::uint64_t seed) {
  Chance chance(seed * 8 + static_cast<std::uint64_t>(LogClass::kOutside));
  const Phenomenon& phenomenon = phenomena()[seed % phenomena().size()];
  Wishes wishes;
  wishes.declares_friction = chance.happens(0.3);
  Bench bench = draw_bench(wishes, chance);
  for (RunPlan& plan : bench.runs) {
    plan.speed_rad_s = scaled(std::move(plan.speed_rad_s), phenomenon.speed);
  }
  Dial dial = dial_of(phenomenon, chance.bits());
  const double strength = tune(bench, dial, chance.scale(3.0, kMostMultiple));
  dial.set(bench, dial.effect, strength);
  Truth truth;
  truth.log_class = LogClass::kOutside;
  truth.phenomenon = phenomenon.name;
  truth.phenomenon_rms = dial.effect.residual_rms;
  truth.coordinates = phenomenon.coordinates;
  return make_scenario(bench, std::move(truth), seed, chance);
}

}  // namespace torquewright::oracles
