// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/heat/heat_model.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kAmbient_K = 298.15;

Actuator heated(double coefficient_1_K) {
  Actuator actuator = round_actuator();
  actuator.thermal = Thermal{0.8, 2.0, 30.0, 400.0, 390.0, kAmbient_K};
  actuator.effects.push_back(effect("winding_resistance_temperature", {coefficient_1_K}));
  return actuator;
}

/// Errors of both temperatures after 20 s in so many short steps, against one exact step.
NodeTemperatures errors_K(const Actuator& actuator, int steps) {
  constexpr double kAmplitude_A = 20.0;
  constexpr double kTime_s = 20.0;
  const HeatModel model(actuator);
  NodeTemperatures nodes{kAmbient_K, kAmbient_K};
  for (int i = 0; i < steps; ++i) {
    const Instant warm = at_winding_temperature(actuator, nodes.winding_K);
    model.advance(nodes, winding_loss_W(actuator, kAmplitude_A, warm), kTime_s / steps);
  }
  const Warmth exact = model.step(kAmplitude_A * kAmplitude_A, kTime_s).after({0.0, 0.0});
  EXPECT_GT(exact[0], 30.0);
  EXPECT_GT(exact[1], 1.0);
  return {std::abs(nodes.winding_K - kAmbient_K - exact[0]),
          std::abs(nodes.case_K - kAmbient_K - exact[1])};
}

// Oracle: the exact step, and the order of the midpoint rule. The next order is the step over the
// shortest time constant, 0.1 s / 24 s, of it.
TEST(HeatModel, ShortStepsTendToTheExactStepWithTheirSquare) {
  const Actuator actuator = heated(0.0);
  const NodeTemperatures coarse = errors_K(actuator, 200);
  const NodeTemperatures fine = errors_K(actuator, 400);
  EXPECT_NEAR(coarse.winding_K / fine.winding_K, 4.0, 0.02);
  EXPECT_NEAR(coarse.case_K / fine.case_K, 4.0, 0.02);
}

// A step holds the loss at its beginning, where the resistance is still colder: of first order.
TEST(HeatModel, ShortStepsThatHoldTheLossTendToItLinearly) {
  const Actuator actuator = heated(0.0039);
  EXPECT_NEAR(errors_K(actuator, 20000).winding_K / errors_K(actuator, 40000).winding_K, 2.0, 0.01);
}

// Oracle: closed form. Held for long, P = R i^2 flows through both resistances: the case stands 2
// K/W P above the ambient, the winding 2.8 K/W P. 1.5 * 0.25 ohm * 100 A^2 = 37.5 W.
TEST(HeatModel, SettlesWhereAllHeatFlowsOff) {
  const HeatModel model(heated(0.0));
  const Warmth settled = model.step(100.0, 1e6).after({0.0, 0.0});
  EXPECT_NEAR(settled[0], 37.5 * 2.8, 1e-9);
  EXPECT_NEAR(settled[1], 37.5 * 2.0, 1e-9);
  EXPECT_EQ(model.ambient_K(), kAmbient_K);
  EXPECT_EQ(model.limit_K(), 390.0);
}

// Oracle: a step's definition. Two steps of the same current are one of their time, from any state;
// where the resistance grows as well.
TEST(HeatModel, StepsFollowOneAnother) {
  const HeatModel model(heated(0.0039));
  const HeatStep both = then(model.step(50.0, 7.0), model.step(50.0, 30.0));
  const HeatStep one = model.step(50.0, 37.0);
  EXPECT_NEAR(both.duration_s, 37.0, 1e-12);
  for (const Warmth& from : {Warmth{0.0, 0.0}, Warmth{40.0, 0.0}, Warmth{0.0, 25.0}}) {
    EXPECT_NEAR(both.after(from)[0], one.after(from)[0], 1e-12 * 100.0);
    EXPECT_NEAR(both.after(from)[1], one.after(from)[1], 1e-12 * 100.0);
  }
}

// Oracle: the definition, one step taken and then the other.
TEST(HeatModel, UnequalStepsFollowOneAnotherToo) {
  const HeatModel model(heated(0.0039));
  const HeatStep warm = model.step(80.0, 11.0);
  const HeatStep cool = model.step(0.0, 23.0);
  const Warmth from{12.0, 5.0};
  const Warmth expected = cool.after(warm.after(from));
  const Warmth found = then(warm, cool).after(from);
  EXPECT_NEAR(found[0], expected[0], 1e-12 * 100.0);
  EXPECT_NEAR(found[1], expected[1], 1e-12 * 100.0);
}

// Oracle: R i^2 of the equivalent winding (0.5 ohm), with copper's 0.0039 1/K, 100 K warmer; its
// ampere is 2/sqrt(3) of a phase's amplitude.
TEST(TemperatureLaws, LossIsThatOfTheEquivalentWinding) {
  const Actuator actuator = round_actuator();
  const Instant hot = at_winding_temperature(actuator, kDefaultTemperature_K + 100.0);
  EXPECT_NEAR(winding_loss_W(actuator, 3.0 * 2.0 / std::sqrt(3.0), hot), 0.5 * 1.39 * 9.0, 1e-12);
}

TEST(TemperatureLaws, AStatedResistanceTakesThePlaceOfCoppers) {
  Actuator actuator = round_actuator();
  const Instant hot = at_winding_temperature(actuator, kDefaultTemperature_K + 100.0);
  EXPECT_EQ(resistance_coefficient_1_K(actuator), 0.0039);
  EXPECT_NEAR(resistance_factor(actuator, hot), 1.39, 1e-15);
  actuator.effects.push_back(effect("winding_resistance_temperature", {0.005}));
  EXPECT_EQ(resistance_coefficient_1_K(actuator), 0.005);
  EXPECT_NEAR(resistance_factor(actuator, hot), 1.5, 1e-15);
}

TEST(TemperatureLaws, FluxFollowsItsEffectsAlone) {
  Actuator actuator = round_actuator();
  const Instant hot = at_winding_temperature(actuator, kDefaultTemperature_K + 100.0);
  EXPECT_EQ(flux_factor(actuator, hot), 1.0);
  actuator.effects.push_back(effect("torque_constant_temperature", {-0.001}));
  EXPECT_NEAR(flux_factor(actuator, hot), 0.9, 1e-15);
}

}  // namespace
}  // namespace torquewright::actuator
