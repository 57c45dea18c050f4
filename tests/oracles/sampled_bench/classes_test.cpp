// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/classes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/candidates.hpp"
#include "tests/oracles/sampled_bench/documents.hpp"
#include "tests/oracles/sampled_bench/outside.hpp"
#include "tests/oracles/sampled_bench/sizes.hpp"

namespace torquewright::oracles::sampled {
namespace {

class EveryClass : public testing::TestWithParam<std::string> {};

/// Two runs of a few seconds are enough for what is tested here.
Situation brief(Situation situation) {
  situation.runs.resize(2);
  for (RunPlan& run : situation.runs) run.duration_s = 4.0;
  return situation;
}

/// Drawn once for all tests below.
const Situation& dynamometer() {
  static const Situation kSituation = brief(draw_bench("coulomb_load", 1).situation);
  return kSituation;
}

// Oracle: what the class promises; the same draws, for everything written follows from class and
// seed.
TEST_P(EveryClass, HidesWhatItPromises) {
  const Bench bench = draw_bench(GetParam(), 5);
  const nlohmann::json truth = truth_document(bench);
  std::size_t promised = 1;
  if (GetParam() == "none" || GetParam() == "outside") promised = 0;
  if (GetParam() == "two" || GetParam() == "coulomb_load") promised = 2;
  EXPECT_EQ(truth.at("effects").size(), promised);
  EXPECT_EQ(truth.at("accept").size(), promised);
  EXPECT_EQ(truth.contains("outside"), GetParam() == "outside");
  const std::string stated = actuator_document(bench.situation).at("effects").dump();
  for (std::size_t k = 0; k < promised; ++k) {
    const std::string name = truth.at("effects")[k].at("effect");
    EXPECT_EQ(stated.find(name), std::string::npos) << name;
    EXPECT_NE(truth.at("accept")[k].dump().find(name), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Classes, EveryClass, testing::ValuesIn(class_names()),
                         [](const auto& chosen) { return chosen.param; });

// Oracle: the same draws. Everything that is written follows from class and seed.
TEST(SampledClasses, AreTheSameForTheSameSeed) {
  const Bench bench = draw_bench("one", 5);
  const Bench again = draw_bench("one", 5);
  EXPECT_EQ(log_csv(bench), log_csv(again));
  EXPECT_EQ(truth_document(bench), truth_document(again));
  EXPECT_NE(log_csv(bench), log_csv(draw_bench("one", 6)));
}

// Oracle: an offset in the torque channel changes the balance by itself.
TEST(SampledSizes, AreThatOfAnOffset) {
  Situation s = dynamometer();
  s.hidden = {{"torque_offset", {{"value", 0.07 * s.plant.used_torque_Nm}}}};
  const Record log = record(s);
  const Record clean = record_without_faults(s, log);
  const double change = change_rms(s, log, clean, "torque_offset");
  // The converter's steps differ; dithered, they leave a share of the noise.
  EXPECT_NEAR(change, 0.07 * s.plant.used_torque_Nm, noise_rms(s, clean, Equation::kTorque));
}

// Oracle: |sgn| = 1. Coulomb friction alone changes the balance by its level wherever it moves,
// less what reversals lose to the band.
TEST(SampledSizes, AreThatOfDryFriction) {
  Situation s = dynamometer();
  s.plant.forward_efficiency = s.plant.backward_efficiency = 1.0;
  for (RunPlan& run : s.runs)
    run.reference = Signal{.constant = 1.0, .sines = {}, .chirps = {}, .levels = {}};
  s.hidden = {{"coulomb_friction", {{"coulomb_Nm", 0.1}}}};
  const Record log = record(s);
  EXPECT_NEAR(change_rms(s, log, log, "coulomb_friction"), 0.1, 1e-9);
}

// Oracle: statistics. The noise of a torque channel alone, in the band, is sigma sqrt(2 B / rate).
TEST(SampledSizes, HoldTheNoiseThatIsStated) {
  Situation s = dynamometer();
  for (Sensor& sensor : s.chain.sensors) sensor.noise = sensor.resolution = 0.0;
  s.chain.filter_hz = 0.0;
  s.hidden.clear();
  s.chain.sensors[kTorque].noise = 1.0;
  for (RunPlan& run : s.runs) run.duration_s = 100.0;
  const Record log = record(s);
  const double share = 2.0 * kBand_hz * log.period_s;
  double samples = 0.0;
  for (const RunLog& run : log.runs) samples += static_cast<double>(run.truth.size());
  // Twice through a second-order Butterworth: noise band 0.833 of the corner. Five standard errors.
  const double expected = std::sqrt(0.833 * share);
  EXPECT_NEAR(noise_rms(s, log, Equation::kTorque), expected,
              5.0 * expected / std::sqrt(2.0 * samples * share) + 0.02 * expected);
}

// Oracle: the table of the contract. Each effect changes its balance, and more at more strength.
TEST(SampledEffects, GrowWithTheirStrength) {
  const Plant& plant = dynamometer().plant;
  Laws stated;
  stated.coulomb_positive_Nm = stated.coulomb_negative_Nm = 0.1 * plant.used_torque_Nm;
  for (const std::string& name : candidates(plant)) {
    const Effect weak = draw_effect(name, 0.1, 7, plant, stated);
    const Effect strong = draw_effect(name, 0.2, 7, plant, stated);
    EXPECT_NE(weak.parameters, strong.parameters) << name;
    EXPECT_EQ(weak.parameters, draw_effect(name, 0.1, 7, plant, stated).parameters) << name;
  }
}

// Oracle: definition. Neutralised, a law is as it was before.
TEST(SampledEffects, LeaveNothingWhenNeutralised) {
  const Plant& plant = dynamometer().plant;
  Situation bare = dynamometer();
  bare.hidden.clear();
  Instant at = record(bare).runs[0].truth[500];
  at.torque_current_A = 0.9 * at.current_A;
  at.winding_K += 30.0;
  for (const std::string name :
       {"viscous_friction", "coulomb_friction", "quadratic_drag", "load_dependent_friction",
        "torque_constant_saturation", "torque_constant_temperature", "cogging_torque",
        "gear_ripple", "reflected_inertia", "torque_constant_error", "gravity_imbalance",
        "torque_lag"}) {
    Laws laws;
    SamplingChain chain;
    const double before = predicted_torque_Nm(plant, laws, at);
    apply(draw_effect(name, 0.5, 11, plant, laws), plant, laws, chain);
    EXPECT_NE(predicted_torque_Nm(plant, laws, at), before) << name;
    neutralise(name, laws);
    EXPECT_EQ(predicted_torque_Nm(plant, laws, at), before) << name;
  }
}

// Oracle: definition. Each kind of foreign physics shows in the balance it is said to show in.
TEST(SampledOutside, EveryKindShows) {
  EXPECT_GE(outside_kinds().size(), 12U);
  const Situation pendulum = brief(draw_bench("outside", 1).situation);
  for (const OutsideKind& kind : outside_kinds()) {
    Situation s = kind.load == LoadKind::kPendulum ? pendulum : dynamometer();
    s.chain.sensors[kOutputPosition].is_logged = s.chain.sensors[kMotorPosition].is_logged = true;
    set_outside(s, kind, 0.5, 3);
    const Record log = record(s);
    EXPECT_GT(oddity_rms(s, log, record_without_faults(s, log)), 0.0) << kind.name;
  }
}

}  // namespace
}  // namespace torquewright::oracles::sampled
