// SPDX-License-Identifier: Apache-2.0
// Oracle: laws of closed form, and what was put into them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "identification/answer/analysis.hpp"
#include "identification/answer/parameters_json.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::named_values_test {
namespace {

using made::Made;
using made::MadeBench;

constexpr double kErrors = 4.0;  ///< Standard errors, of one fixed log.
constexpr double kModel = 0.02;  ///< Relative: the filter's smear of what is steep at rest.

EquationResult torque_of(const Log& log) {
  const MadeBench made;
  return analyse(made.rig, log, 0, {&made.actuator}).front();
}

const NamedEffect* find(const EquationResult& result, const std::string& effect) {
  const auto found = std::find_if(result.added.begin(), result.added.end(),
                                  [&](const NamedEffect& each) { return each.effect == effect; });
  return found == result.added.end() ? nullptr : &*found;
}

void expect_value(const EquationResult& result, const std::string& effect, const char* name,
                  double truth) {
  const NamedEffect* found = find(result, effect);
  ASSERT_NE(found, nullptr) << effect;
  const double error = found->parameters.standard_error(name);
  EXPECT_NEAR(found->parameters.value(name, NAN), truth, kErrors * error + kModel * truth)
      << effect << " " << name;
}

TEST(CurvedLaws, StribeckFrictionHasItsVelocity) {
  const EquationResult result = torque_of(MadeBench().log([](const Made& at) {
    const double over = at.speed_rad_s / 0.37;
    return -made::sign(at.speed_rad_s) * (0.5 + 0.8 * std::exp(-over * over));
  }));
  expect_value(result, "stribeck_friction", "stribeck_velocity_rad_s", 0.37);
}

TEST(CurvedLaws, SaturationHasItsCurrentAndExponent) {
  const EquationResult result = torque_of(MadeBench().log([](const Made& at) {
    return at.torque_Nm *
           (std::pow(1.0 + std::pow(std::abs(at.current_A) / 11.0, 2.6), -1.0 / 2.6) - 1.0);
  }));
  expect_value(result, "torque_constant_saturation", "saturation_current_A", 11.0);
  expect_value(result, "torque_constant_saturation", "exponent", 2.6);
}

double friction(const Made& at) { return -0.4 * made::sign(at.speed_rad_s) - 0.2 * at.speed_rad_s; }

/// 0.3 ms is a sixteenth of a sample of the log.
void expect_delay(const EquationResult& result, const char* channel, double delay_s) {
  const NamedEffect* found = find(result, "channel_delay");
  std::string named;
  for (const NamedEffect& each : result.added)
    named += each.effect + parameters_json(each.parameters).dump() + " ";
  named += std::to_string(result.has_tentative);
  ASSERT_NE(found, nullptr) << named;
  EXPECT_EQ(found->parameters.channel, channel);
  EXPECT_NEAR(found->parameters.value("delay_s", NAN), delay_s, 3e-4);
}

TEST(LateChannel, IsTheSensorBesideFriction) {
  for (const double late_s : {0.012, 0.078}) {
    expect_delay(torque_of(MadeBench().log(friction, 0.05, late_s)), "output_torque_Nm", late_s);
  }
}

// A sensor that is early is a drive that is late.
TEST(LateChannel, IsTheOtherWhereTheSensorIsEarly) {
  expect_delay(torque_of(MadeBench().log(friction, 0.05, -0.02)), "motor_current_A", 0.02);
}

// Missing viscous friction moves the torque of a sine like a delay. One run alone is cut into
// pieces, so that there is something to leave out.
TEST(LateChannel, IsNotFrictionInOneRunEither) {
  for (const double late_s : {0.0, 0.03}) {
    const Log several = MadeBench().log(friction, 0.05, late_s);
    Log log = several;
    log.runs = Runs();
    log.runs.push_back(several.runs[0]);
    log.train_runs = {"run_0"};
    log.holdout_runs.clear();
    for (const EquationResult& result : {torque_of(several), torque_of(log)}) {
      if (late_s > 0.0) {
        expect_delay(result, "output_torque_Nm", late_s);
      } else {
        EXPECT_EQ(find(result, "channel_delay"), nullptr);
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::identification::named_values_test
