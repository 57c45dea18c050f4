// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tests/oracles/bench_log/dial.hpp"

namespace torquewright::oracles {
namespace {

void name_coulomb_and_viscous(const Friction& law, TrueEffect& effect) {
  effect.parameters["coulomb_positive_Nm"] = law.coulomb_positive_Nm;
  effect.parameters["coulomb_negative_Nm"] = law.coulomb_negative_Nm;
  effect.parameters["viscous_positive_Nm_s_rad"] = law.viscous_positive_Nm_s_rad;
  effect.parameters["viscous_negative_Nm_s_rad"] = law.viscous_negative_Nm_s_rad;
}

// Each direction differs in both terms, and not alike: Coulomb alone would be an offset.
Dial asymmetric(const Bench&, Chance& chance) {
  const double toward = chance.sign();
  const double viscous = toward * chance.between(0.8, 1.2);
  const auto set = [toward, viscous](Bench& bench, TrueEffect& effect, double strength) {
    Friction& law = bench.truth.friction;
    law.coulomb_positive_Nm *= 1.0 + toward * strength;
    law.coulomb_negative_Nm *= 1.0 - toward * strength;
    law.viscous_positive_Nm_s_rad *= 1.0 + viscous * strength;
    law.viscous_negative_Nm_s_rad *= 1.0 - viscous * strength;
    name_coulomb_and_viscous(law, effect);
  };
  return {{}, 0.02, 0.2, 0.8, set};
}

Dial stribeck(const Bench& bench, Chance& chance) {
  const double speed = rounded(chance.between(0.2, 0.6));
  const double level = std::max(bench.nominal.friction.coulomb_positive_Nm, 1e-3);
  const auto set = [speed](Bench& b, TrueEffect& effect, double strength) {
    Friction& law = b.truth.friction;
    law.breakaway_excess_Nm = strength;
    law.stribeck_velocity_rad_s = speed;
    effect.parameters = {{"coulomb_Nm", law.coulomb_positive_Nm},
                         {"breakaway_Nm", law.coulomb_positive_Nm + strength},
                         {"stribeck_velocity_rad_s", speed}};
  };
  return {{}, 0.05 * level, 0.5 * level, 2.5 * level, set};
}

Dial presliding(const Bench& bench, Chance&) {
  const bool is_linear = bench.nominal.load.type == Load::Type::kLinearAxis;
  const double unit = is_linear ? 0.1 : 1.0;
  // Its strength is the length over which the torque builds up.
  const auto set = [](Bench& b, TrueEffect& effect, double strength) {
    Friction& law = b.truth.friction;
    law.presliding_Nm_rad = law.coulomb_positive_Nm / strength;
    effect.parameters = {{"coulomb_Nm", law.coulomb_positive_Nm},
                         {"stiffness_Nm_rad", law.presliding_Nm_rad}};
  };
  return {{}, 0.02 * unit, 0.08 * unit, 0.3 * unit, set};
}

Dial over_position(const Bench& bench, Chance& chance) {
  const auto drawn = static_cast<int>(2 + chance.index(4));
  const auto order = static_cast<double>(std::max(drawn, least_order(bench)));
  const double phase = chance.phase();
  const double level = std::max(bench.nominal.friction.coulomb_positive_Nm, 1e-3);
  const auto set = [order, phase](Bench& b, TrueEffect& effect, double strength) {
    b.truth.friction.over_position.terms = {{order, strength, phase}};
    effect.harmonics = b.truth.friction.over_position.terms;
  };
  return {{}, 0.02 * level, 0.3 * level, 0.85 * level, set};
}

}  // namespace

Dial friction_dial(const std::string& name, const Bench& bench, Chance& chance) {
  const double peak = peak_torque_Nm(bench.nominal);
  const double per_speed = bench.nominal.load.type == Load::Type::kLinearAxis ? 10.0 : 1.0;
  if (name == "viscous_friction") {
    return {
        {},
        1e-4 * peak,
        1e-2 * peak,
        0.1 * peak * per_speed,
        [](Bench& b, TrueEffect& effect, double strength) {
          b.truth.friction.viscous_positive_Nm_s_rad += strength;
          b.truth.friction.viscous_negative_Nm_s_rad += strength;
          // As a document would state it: all of it, with what was declared.
          effect.parameters = {{"viscous_Nm_s_rad", b.truth.friction.viscous_positive_Nm_s_rad}};
        }};
  }
  if (name == "coulomb_friction") {
    return {{},
            1e-4 * peak,
            1e-2 * peak,
            0.1 * peak,
            [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.friction.coulomb_positive_Nm += strength;
              b.truth.friction.coulomb_negative_Nm += strength;
              effect.parameters = {{"coulomb_Nm", b.truth.friction.coulomb_positive_Nm}};
            }};
  }
  if (name == "quadratic_drag") {
    return {{},
            1e-5 * peak,
            2e-3 * peak,
            0.05 * peak * per_speed * per_speed,
            [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.friction.drag_Nm_s2_rad2 = strength;
              effect.parameters = {{"drag_Nm_s2_rad2", strength}};
            }};
  }
  if (name == "friction_temperature") {
    return {{}, 5e-4, 4e-3, 0.012, [](Bench& b, TrueEffect& effect, double strength) {
              b.truth.friction.coefficient_1_K = -strength;  // Grease thins.
              effect.parameters = {{"coefficient_1_K", -strength}};
            }};
  }
  if (name == "load_dependent_friction") {
    const double uneven = chance.between(0.7, 1.3);
    return {{}, 1e-3, 0.03, 0.3, [uneven](Bench& b, TrueEffect& effect, double strength) {
              b.truth.driving_coefficient = strength;
              b.truth.backdriving_coefficient = uneven * strength;
              effect.parameters = {{"driving_coefficient", strength},
                                   {"backdriving_coefficient", uneven * strength}};
            }};
  }
  if (name == "asymmetric_friction") return asymmetric(bench, chance);
  if (name == "stribeck_friction") return stribeck(bench, chance);
  if (name == "presliding_friction") return presliding(bench, chance);
  if (name == "position_dependent_friction") return over_position(bench, chance);
  return {};
}

}  // namespace torquewright::oracles
