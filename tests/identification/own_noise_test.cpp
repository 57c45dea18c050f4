// SPDX-License-Identifier: Apache-2.0
// What multiplies an acceleration multiplies its noise, and explains nothing by that. Oracles: the
// closed forms that made the logs of two slow joints, and the white noise that was put on them.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "identification/answer/analysis.hpp"
#include "tests/identification/free_joint.hpp"

namespace torquewright::identification::own_noise_test {
namespace {

constexpr double kNm_per_A = 10.0, kPositionNoise_rad = 5e-4;

/// A joint on a free load of which the rig states an inertia and calls it uncertain.
struct SlowJoint : test_logs::FreeJoint {
  SlowJoint(double stated_kg_m2, double current_noise_A)
      : FreeJoint(stated_kg_m2), noise_A(current_noise_A) {
    rig.uncertain = {"/load/inertia_kg_m2"};
  }

  /// Of a sine of one rate about a centre, with the torque as a law of angle, speed and
  /// acceleration.
  EquationResult torque_of(double centre_rad, double stroke_rad, double rate_rad_s,
                           const std::function<double(double, double, double)>& law) const {
    std::mt19937_64 random(1);
    std::normal_distribution<double> unit(0.0, 1.0);
    const Log log = test_logs::three_runs([&](std::size_t r, double t, Run& run) {
      const double phase = rate_rad_s * t + 2.0 * static_cast<double>(r);
      const double off = stroke_rad * std::sin(phase);
      const double speed = stroke_rad * rate_rad_s * std::cos(phase);
      const double torque = law(centre_rad + off, speed, -rate_rad_s * rate_rad_s * off);
      run.joints[0][Quantity::kOutputPosition].push_back(centre_rad + off +
                                                         kPositionNoise_rad * unit(random));
      run.joints[0][Quantity::kMotorCurrent].push_back(torque / kNm_per_A + noise_A * unit(random));
    });
    return analyse(rig, log, 0, {&actuator}, {}).front();
  }

  double noise_A;
};

double sign(double value) { return value > 0.0 ? 1.0 : -1.0; }

/// A weight of 3 Nm that the rig does not state, about its upper rest: at one rate it is an inertia
/// of 3 kg m2 more, whose noise is six times that of what is stated.
TEST(OwnNoise, IsNoFloorForAnInertiaOfSeveralTimesWhatIsStated) {
  constexpr double kInertia_kg_m2 = 0.4, kWeight_Nm = 3.0, kNoise_A = 0.03;
  const EquationResult result =
      SlowJoint(kInertia_kg_m2, kNoise_A)
          .torque_of(3.3, 0.52, 1.0, [](double q, double v, double a) {
            return kInertia_kg_m2 * a + kWeight_Nm * std::sin(q) + sign(v);
          });
  // No more than the current's own noise, of which the band holds a sixth; the inertia's is less.
  EXPECT_LT(result.noise_floor_rms, kNoise_A);
  ASSERT_EQ(result.corrected.size(), 1U);
  EXPECT_GT(result.corrected[0].value, 5.0 * kInertia_kg_m2);
  EXPECT_GT(result.after.train_rms, 3.0 * result.noise_floor_rms);
  EXPECT_NE(result.verdict, Verdict::kExplained);
  EXPECT_NE(result.verdict, Verdict::kNothingMissing);
}

/// Friction in proportion to the load, of an inertia alone, would have to be several times the
/// load, and leaves several times its noise: it is no rival of Coulomb friction, which is there.
TEST(OwnNoise, MakesNoRivalOfFrictionInProportionToTheLoad) {
  constexpr double kInertia_kg_m2 = 5.4, kCoulomb_Nm = 14.5, kNoise_A = 0.15;
  const EquationResult result =
      SlowJoint(5.0, kNoise_A).torque_of(-1.03, 1.55, 0.628, [](double, double v, double a) {
        return kInertia_kg_m2 * a + kCoulomb_Nm * sign(v) +
               20.9 * std::pow(std::abs(v), 0.7) * sign(v);
      });
  EXPECT_TRUE(is_certain(result, "coulomb_friction"));
  for (const Confounded& group : result.confounded) {
    for (const std::string& each : group.effects) EXPECT_NE(each, "load_dependent_friction");
  }
  for (const ModelWithinNoise& each : result.models) {
    EXPECT_LT(each.errors.holdout_rms, 1.3 * 1.3 * result.after.holdout_rms);
  }
}

}  // namespace
}  // namespace torquewright::identification::own_noise_test
