// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tests/oracles/bench_log/dial.hpp"

namespace torquewright::oracles {
namespace {

Dial electrical(Dial dial, const char* equation) {
  dial.effect.equation = equation;
  return dial;
}

Dial saturation(const Bench& bench, Chance& chance) {
  const double exponent = rounded(chance.between(1.8, 3.0), 2);
  const double peak = bench.nominal.peak_current_A;
  // Its strength is the share lost at the peak current, roughly.
  const auto set = [exponent, peak](Bench& b, TrueEffect& effect, double strength) {
    b.truth.saturation_exponent = exponent;
    b.truth.saturation_current_A = peak / std::pow(strength * exponent, 1.0 / exponent);
    effect.parameters = {{"saturation_current_A", b.truth.saturation_current_A},
                         {"exponent", exponent}};
  };
  return {{}, 0.005, 0.05, 0.5, set};
}

}  // namespace

Dial motor_dial(const std::string& name, const Bench& bench, Chance& chance) {
  if (name == "torque_constant_saturation") return saturation(bench, chance);
  if (name == "torque_constant_temperature") {
    return {{}, 2e-4, 1e-3, 4e-3, [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.torque_constant_1_K = -strength;  // Magnets lose flux.
              effect.parameters = {{"coefficient_1_K", -strength}};
            }};
  }
  if (name == "torque_constant_error") {
    const double sign = chance.sign();
    return {{}, 0.003, 0.05, 0.25, [sign](Bench& b, TrueEffect& effect, double strength) {
              b.truth.torque_constant_factor = 1.0 + sign * strength;
              effect.parameters = {{"factor", b.truth.torque_constant_factor}};
            }};
  }
  if (name == "torque_lag") {
    return {{}, 0.012, 0.02, 0.06, [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.lag_s = strength;
              effect.parameters = {{"time_constant_s", strength}};
            }};
  }
  if (name == "reflected_inertia") {
    const double stated = bench.nominal.motor_inertia_kg_m2();
    return {{},
            0.01 * stated,
            0.2 * stated,
            2.0 * stated,
            [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.extra_inertia_kg_m2 = strength;
              effect.parameters = {{"inertia_kg_m2", strength}};
            }};
  }
  if (name == "voltage_sag") {
    return electrical({{},
                       0.02,
                       0.06,
                       0.15,
                       [](Bench& b, TrueEffect& effect, double strength) {
                         b.truth.sag_ohm = strength;
                         effect.parameters = {{"resistance_ohm", strength}};
                       }},
                      "bus");
  }
  if (name == "winding_resistance_temperature") {
    return electrical({{},
                       1e-3,
                       2e-3,
                       3.5e-3,
                       [](Bench& b, TrueEffect& effect, double strength) {
                         b.truth.resistance_1_K = kCopper_1_K + strength;
                         effect.parameters = {{"coefficient_1_K", b.truth.resistance_1_K}};
                       }},
                      "electrical");
  }
  if (name == "inverter_dead_time") {
    return electrical({{},
                       0.1,
                       0.4,
                       1.2,
                       [](Bench& b, TrueEffect& effect, double strength) {
                         b.truth.dead_time_V = strength;
                         effect.parameters = {{"voltage_V", strength}};
                       }},
                      "electrical");
  }
  return {};
}

}  // namespace torquewright::oracles
