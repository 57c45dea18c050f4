// SPDX-License-Identifier: Apache-2.0
// What multiplies an acceleration multiplies its noise, and explains nothing by that. Oracles: the
// closed forms that made the logs of two slow joints, and the white noise that was put on them.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "identification/answer/analysis.hpp"

namespace torquewright::identification::own_noise_test {
namespace {

constexpr double kNm_per_A = 10.0, kStep_s = 0.01, kPositionNoise_rad = 5e-4;

/// A joint on a free load of which the rig states an inertia and calls it uncertain.
struct SlowJoint {
  SlowJoint(double stated_kg_m2, double current_noise_A) : noise_A(current_noise_A) {
    rig.joints = {""};
    rig.load.type = LoadType::kFree;
    rig.load.inertia_kg_m2 = stated_kg_m2;
    rig.uncertain = {"/load/inertia_kg_m2"};
    actuator.motor.torque_constant_Nm_A = 0.1;
    actuator.motor.resistance_ohm = 0.3;
    actuator.motor.pole_pairs = 7;
    actuator.drive.bus_voltage_V = 48.0;
    actuator.drive.peak_current_A = 60.0;
    actuator.transmission.ratio = 100.0;
  }

  /// Of a sine of one rate about a centre, with the torque as a law of angle, speed and
  /// acceleration.
  EquationResult torque_of(double centre_rad, double stroke_rad, double rate_rad_s,
                           const std::function<double(double, double, double)>& law) const {
    std::mt19937_64 random(1);
    std::normal_distribution<double> unit(0.0, 1.0);
    Log log;
    for (std::size_t r = 0; r < 3; ++r) {
      Run run;
      run.name = "run_" + std::to_string(r);
      (r == 2 ? log.holdout_runs : log.train_runs).push_back(run.name);
      run.joints.resize(1);
      for (int k = 0; k < 3000; ++k) {
        const double t = kStep_s * k, phase = rate_rad_s * t + 2.0 * static_cast<double>(r);
        const double off = stroke_rad * std::sin(phase);
        const double speed = stroke_rad * rate_rad_s * std::cos(phase);
        const double torque = law(centre_rad + off, speed, -rate_rad_s * rate_rad_s * off);
        run.time_s.push_back(t);
        run.joints[0][Quantity::kOutputPosition].push_back(centre_rad + off +
                                                           kPositionNoise_rad * unit(random));
        run.joints[0][Quantity::kMotorCurrent].push_back(torque / kNm_per_A +
                                                         noise_A * unit(random));
      }
      run.masked.assign(run.time_s.size(), 0);
      log.runs.push_back(std::move(run));
    }
    return analyse(rig, log, 0, {&actuator}, {}).front();
  }

  Rig rig;
  actuator::Actuator actuator;
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
