// SPDX-License-Identifier: Apache-2.0
// The twist of a train with hysteresis under a torque that is given, against the torque that a
// given twist takes in closed form.
#include "identification/forward/twist_under_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

constexpr double kSpring_Nm_rad = 900.0;
constexpr double kAmplitude_Nm = 2.0;
constexpr double kTurn_rad = 0.003;

actuator::Effect effect(const char* name, std::vector<double> values) {
  return {actuator::find_effect(name), std::move(values), {}, false, ""};
}

/// A twist that goes back and forth between turning points, and the torque that it takes: along a
/// branch u = d - (d - u0) exp(-|x - x0| / s), T = k x + Z (6 u - u^3) / 5.
struct Branches {
  std::vector<double> twist_rad;
  std::vector<actuator::Instant> at;

  Branches(const std::vector<double>& turning_rad, int samples) {
    double from_rad = 0.0, from_u = 0.0;
    for (const double to_rad : turning_rad) {
      const double direction = to_rad < from_rad ? -1.0 : 1.0;
      double u = from_u;
      for (int i = 0; i <= samples; ++i) {
        const double x_rad = from_rad + (to_rad - from_rad) * i / samples;
        u = direction - (direction - from_u) * std::exp(-std::abs(x_rad - from_rad) / kTurn_rad);
        twist_rad.push_back(x_rad);
        at.emplace_back().load_torque_Nm =
            kSpring_Nm_rad * x_rad + kAmplitude_Nm * (6.0 * u - u * u * u) / 5.0;
      }
      from_rad = to_rad;
      from_u = u;
    }
  }
};

actuator::Actuator with_hysteresis() {
  actuator::Actuator actuator;
  actuator.effects = {effect("torsional_compliance", {kSpring_Nm_rad, 0.0}),
                      effect("strain_wave_hysteresis", {kAmplitude_Nm, kTurn_rad})};
  return actuator;
}

// Oracle: the closed form, at every sample and however few of them there are; four steps of Newton
// from below leave no more than rounding.
TEST(TwistUnderLoad, IsTheTwistThatTakesTheTorque) {
  for (const int samples : {10, 200}) {
    const Branches made({0.01, -0.004, 0.006, 0.001, 0.02, -0.02}, samples);
    const std::vector<double> twist_rad = twist_under_load_rad(with_hysteresis(), made.at);
    for (std::size_t i = 0; i < twist_rad.size(); ++i) {
      ASSERT_NEAR(twist_rad[i], made.twist_rad[i], 1e-11) << samples << " " << i;
    }
  }
}

// Oracle: without an amplitude, and beside a rigid train, what springs and gaps give by themselves.
TEST(TwistUnderLoad, IsThatOfTheSpringAloneWithoutHysteresis) {
  const Branches made({0.01, -0.01}, 20);
  actuator::Actuator actuator = with_hysteresis();
  actuator.effects[1].values[0] = 0.0;
  const std::vector<double> spring_rad = twist_under_load_rad(actuator, made.at);
  actuator.effects[1].values[0] = kAmplitude_Nm;
  actuator.effects[0].values[0] = INFINITY;
  const std::vector<double> rigid_rad = twist_under_load_rad(actuator, made.at);
  for (std::size_t i = 0; i < made.at.size(); ++i) {
    EXPECT_EQ(spring_rad[i], made.at[i].load_torque_Nm / kSpring_Nm_rad);
    EXPECT_EQ(rigid_rad[i], 0.0);
  }
}

}  // namespace
}  // namespace torquewright::identification
