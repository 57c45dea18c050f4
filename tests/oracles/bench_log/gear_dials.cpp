// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/oracles/bench_log/dial.hpp"

namespace torquewright::oracles {
namespace {

std::vector<Harmonic> times(std::vector<Harmonic> terms, double factor) {
  for (Harmonic& term : terms) term.amplitude *= factor;
  return terms;
}

Dial cogging(const Bench& bench, Chance& chance) {
  const std::array<double, 4> orders{2.0, 4.0, 6.0, 7.0};
  std::vector<Harmonic> terms{{chance.one_of(orders), 1.0, chance.phase()}};
  if (chance.happens(0.5)) terms.push_back({2.0 * terms[0].order, 0.5, chance.phase()});
  const double peak = peak_torque_Nm(bench.nominal);
  return {{},
          1e-4 * peak,
          5e-3 * peak,
          0.1 * peak,
          [terms](Bench& b, TrueEffect& effect, double strength) {
            b.truth.cogging.terms = effect.harmonics = times(terms, strength);
          }};
}

Dial ripple(const Bench& bench, Chance& chance) {
  // What turns through less than a period is any smooth function of the angle.
  const auto drawn = static_cast<int>(3 + chance.index(7));
  const auto order = static_cast<double>(std::max(drawn, least_order(bench)));
  std::vector<Harmonic> terms{{order, 1.0, chance.phase()}};
  const bool proportional = chance.happens(0.5);
  const double unit = proportional ? 1.0 : peak_torque_Nm(bench.nominal);
  Dial dial{{},
            1e-4 * unit,
            1e-2 * unit,
            0.3 * unit,
            [terms, proportional](Bench& b, TrueEffect& effect, double strength) {
              (proportional ? b.truth.load_ripple : b.truth.ripple).terms = effect.harmonics =
                  times(terms, strength);
            }};
  dial.effect.proportional = proportional;
  return dial;
}

}  // namespace

Dial gear_dial(const std::string& name, const Bench& bench, Chance& chance) {
  if (name == "cogging_torque") return cogging(bench, chance);
  if (name == "gear_ripple") return ripple(bench, chance);
  Dial dial;
  if (name == "backlash") {
    dial = {{}, 0.004, 0.012, 0.03, [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.gap_rad = strength;
              effect.parameters = {{"gap_rad", strength}};
            }};
  }
  if (name == "torsional_compliance") {
    const double peak = peak_torque_Nm(bench.nominal);
    const double inertia = bench.nominal.motor_inertia_kg_m2();
    // Its strength is the twist under the peak torque.
    dial = {{}, 0.005, 0.02, 0.06, [peak, inertia](Bench& b, TrueEffect& effect, double strength) {
              const double stiffness = peak / strength;
              b.truth.stiffness_Nm_rad = stiffness;
              b.truth.damping_Nm_s_rad = 0.4 * std::sqrt(stiffness * inertia);
              effect.parameters = {{"stiffness_Nm_rad", stiffness},
                                   {"damping_Nm_s_rad", b.truth.damping_Nm_s_rad}};
            }};
  }
  dial.effect.equation = "kinematic";
  return dial;
}

}  // namespace torquewright::oracles
