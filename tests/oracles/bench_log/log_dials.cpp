// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tests/oracles/bench_log/dial.hpp"

namespace torquewright::oracles {
namespace {

Dial of_family(const char* family, Dial dial) {
  dial.effect.family = family;
  return dial;
}

Dial offset(const char* what, const Bench& bench, Chance& chance) {
  const double sign = chance.sign();
  if (std::string(what) == "torque_offset") {
    const double peak = peak_torque_Nm(bench.nominal);
    return {{},
            1e-4 * peak,
            5e-3 * peak,
            0.1 * peak,
            [sign](Bench& b, TrueEffect& effect, double strength) {
              b.faults.torque_offset = sign * strength;
              effect.parameters = {{"value", sign * strength}};
            }};
  }
  const double peak = bench.nominal.peak_current_A;
  return {{},
          1e-4 * peak,
          5e-3 * peak,
          0.1 * peak,
          [sign](Bench& b, TrueEffect& effect, double strength) {
            b.faults.current_offset_A = sign * strength;
            effect.parameters = {{"value", sign * strength}};
          }};
}

Dial delay(const Bench& bench, Chance& chance) {
  const bool has_sensor = bench.nominal.load.type == Load::Type::kDynamometer;
  const std::string channel =
      has_sensor && chance.happens(0.5) ? "output_torque_Nm" : "motor_current_A";
  Dial dial{{}, 0.006, 0.015, 0.04, [channel](Bench& b, TrueEffect& effect, double strength) {
              b.faults.late_channel = channel;
              b.faults.late_s = strength;
              effect.parameters = {{"delay_s", strength}};
            }};
  dial.effect.channel = channel;
  return dial;
}

Dial velocity(Chance& chance) {
  const double sign = chance.sign();
  const double late = chance.between(0.1, 0.4);
  Dial dial{{}, 0.01, 0.03, 0.1, [sign, late](Bench& b, TrueEffect& effect, double strength) {
              b.faults.velocity_scale = 1.0 + sign * strength;
              b.faults.velocity_late_s = late * strength;
              effect.parameters = {{"scale", b.faults.velocity_scale},
                                   {"delay_s", b.faults.velocity_late_s}};
            }};
  dial.effect.equation = "velocity";
  return dial;
}

Dial imbalance(const Bench& bench, Chance& chance) {
  const double phase = chance.phase();
  const double peak = peak_torque_Nm(bench.nominal);
  return {{},
          1e-4 * peak,
          5e-3 * peak,
          0.1 * peak,
          [phase](Bench& b, TrueEffect& effect, double strength) {
            b.truth.load.imbalance_Nm = strength;
            b.truth.load.imbalance_phase_rad = phase;
            effect.parameters = {{"amplitude_Nm", strength}, {"phase_rad", phase}};
          }};
}

Dial wrong_inertia(Chance& chance) {
  const double sign = chance.sign();
  return {{}, 0.003, 0.03, 0.4, [sign](Bench& b, TrueEffect& effect, double strength) {
            const double error = sign * strength * b.stated.inertia_kg_m2;
            b.truth.load.inertia_kg_m2 += error;
            b.uncertain = {"/load/inertia_kg_m2"};
            effect.parameters = {{"value", error}};
            effect.corrected = {{"/load/inertia_kg_m2", b.stated.inertia_kg_m2 + error}};
          }};
}

Dial wrong_mass(Chance& chance) {
  const double sign = chance.sign();
  return {{}, 0.003, 0.03, 0.4, [sign](Bench& b, TrueEffect& effect, double strength) {
            const double error = sign * strength * b.stated.mass_kg;
            Load& load = b.truth.load;
            if (load.type == Load::Type::kPendulum) {
              load.inertia_kg_m2 += error * b.stated.length_m * b.stated.length_m;
              load.gravity_Nm += error * b.stated.length_m * kGravity_m_s2;
            } else {
              load.inertia_kg_m2 += error;
            }
            b.uncertain = {"/load/mass_kg"};
            effect.parameters = {{"value", error}};
            effect.corrected = {{"/load/mass_kg", b.stated.mass_kg + error}};
          }};
}

}  // namespace

Dial log_dial(const std::string& name, const Bench& bench, Chance& chance) {
  if (name == "torque_offset") return of_family("log", offset("torque_offset", bench, chance));
  if (name == "current_offset") return of_family("log", offset("current_offset", bench, chance));
  if (name == "channel_delay") return of_family("log", delay(bench, chance));
  if (name == "velocity_mismatch") return of_family("log", velocity(chance));
  if (name == "gravity_imbalance") return of_family("rig", imbalance(bench, chance));
  if (name == "load_inertia_error") return of_family("rig", wrong_inertia(chance));
  if (name == "load_mass_error") return of_family("rig", wrong_mass(chance));
  return {};
}

}  // namespace torquewright::oracles
