// SPDX-License-Identifier: Apache-2.0
// What a balance remembers of hypotheses changes no bit of a residual. Oracle: the balance of each
// hypothesis by itself, which has nothing to remember.
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

#include "actuator/effects/library.hpp"
#include "identification/forward/torque_prediction.hpp"
#include "identification/preparation/held_signals.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::torque_balance_test {
namespace {

using actuator::Effect;
using made::MadeBench;
using Change = std::function<void(double size, Hypothesis&)>;

Effect effect(const char* name, std::vector<double> values) {
  return {actuator::find_effect(name), std::move(values), {}, false, ""};
}

void add_wave(const char* name, double size, bool is_proportional, Hypothesis& hypothesis) {
  hypothesis.actuator.effects.push_back(
      {actuator::find_effect(name), {}, {{3.0, size, size}}, is_proportional, ""});
}

/// One for each thing that a balance is made of.
std::vector<Change> changes() {
  const auto adds = [](const char* name, std::vector<double> of_one) {
    return [name, of_one](double size, Hypothesis& hypothesis) {
      std::vector<double> values = of_one;
      values.front() *= size;
      hypothesis.actuator.effects.push_back(effect(name, values));
    };
  };
  return {
      adds("coulomb_friction", {1.0}),
      adds("viscous_friction", {0.1}),
      adds("presliding_friction", {0.5, 20.0}),
      adds("torque_lag", {0.02}),
      adds("torque_constant_error", {1.0}),
      adds("load_dependent_friction", {0.1, 0.1}),
      adds("reflected_inertia", {0.01}),
      adds("parallel_spring", {0.3, 0.1}),
      [](double size, Hypothesis& h) { add_wave("cogging_torque", size, false, h); },
      [](double size, Hypothesis& h) { add_wave("gear_ripple", size, false, h); },
      [](double size, Hypothesis& h) { add_wave("gear_ripple", 0.1 * size, true, h); },
      [](double size, Hypothesis& h) { add_wave("position_dependent_friction", size, false, h); },
      [](double size, Hypothesis& h) { h.log.torque_offset_Nm = size; },
      [](double size, Hypothesis& h) { h.log.current_offset_A = size; },
      [](double size, Hypothesis& h) { h.log.positive_current_gain = size; },
      [](double size, Hypothesis& h) { h.log.instant_s = 0.002 * size; },
      [](double size, Hypothesis& h) { h.imbalance_sine_Nm = size; },
      [](double size, Hypothesis& h) { h.actuator.motor.torque_constant_Nm_A *= size; },
      [](double size, Hypothesis& h) { h.actuator.transmission.ratio *= size; },
      [](double size, Hypothesis& h) {
        h.log.delay_s[static_cast<std::size_t>(Quantity::kOutputPosition)] = 0.01 * size;
      },
      [](double size, Hypothesis& h) {
        h.log.delay_s[static_cast<std::size_t>(Quantity::kOutputTorque)] = 0.01 * size;
      }};
}

/// Three changes of a kind and a size each, of few, so that hypotheses share what they share in a
/// search.
Hypothesis drawn(const Hypothesis& stated, std::mt19937_64& random) {
  static const std::vector<Change> kChanges = changes();
  std::uniform_int_distribution<std::size_t> which(0, kChanges.size() - 1), size(1, 2);
  Hypothesis hypothesis = stated;
  for (int k = 0; k < 3; ++k) {
    kChanges[which(random)](0.7 * static_cast<double>(size(random)), hypothesis);
  }
  return hypothesis;
}

TEST(TorqueBalance, RemembersWithoutChangingABit) {
  const MadeBench made;
  const Log log = made.log([](const auto&) { return 0.0; });
  const Bench bench = made.bench(log);
  const HeldSignals held = held_signals(log, bench, noise_levels(log, 0), 1);
  std::mt19937_64 random(3);
  for (const std::size_t most : {1, 3, 24}) {
    TorqueBalance balance(bench, held.rows.front(), most);
    for (int k = 0; k < 100; ++k) {
      const Hypothesis hypothesis = drawn({made.actuator, made.rig, {}}, random);
      ASSERT_EQ(balance.residual_Nm(hypothesis),
                torque_balance_Nm(bench, hypothesis, held.rows.front()))
          << k << " of " << most;
    }
  }
}

}  // namespace
}  // namespace torquewright::identification::torque_balance_test
