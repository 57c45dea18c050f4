// SPDX-License-Identifier: Apache-2.0
// Oracle: the orders that were put into logs of closed form.
#include "identification/forward/wave_orders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "identification/forward/candidates.hpp"
#include "identification/forward/torque_forward.hpp"
#include "identification/preparation/preparation.hpp"
#include "identification/selection/folds.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::wave_orders_test {
namespace {

using made::Made;
using made::MadeBench;

WaveOrders orders_of(const std::function<double(const Made&)>& added) {
  const MadeBench rig;
  const Log log = rig.log(added);
  const Bench bench = rig.bench(log);
  const std::vector<Signals> signals = prepare(log, bench, noise_levels(log, 0), {});
  const ForwardEquation equation = torque_forward(bench, signals, run_folds(log));
  const auto left = [&](const Signals& s) { return equation.residual(equation.stated, s); };
  return promising_waves(bench, left, signals, run_folds(log), ranges_of(bench, signals));
}

bool holds(const std::vector<double>& orders, double order) {
  return std::find(orders.begin(), orders.end(), order) != orders.end();
}

/// The angle that stretches over these cover together.
double covered_rad(const std::vector<std::pair<double, double>>& spans) {
  const MadeBench rig;
  const Log log = rig.log([](const Made&) { return 0.0; });
  std::vector<Signals> signals;
  for (const auto& [low, high] : spans) {
    signals.emplace_back().at.resize(2);
    signals.back().at[0].output_angle_rad = low;
    signals.back().at[1].output_angle_rad = high;
  }
  return ranges_of(rig.bench(log), signals).angle_rad;
}

// Oracle: by hand. A whole wave of order 4 takes 1.571 rad, which no stretch of 1.47 has.
TEST(WaveOrders, AreThoseOfWhichAllStretchesTogetherHoldAWholeOne) {
  EXPECT_NEAR(covered_rad({{0.0, 1.47}, {0.32, 1.79}}), 1.79, 1e-12);
  EXPECT_NEAR(covered_rad({{2.0, 3.0}, {0.0, 1.0}, {0.2, 0.4}}), 2.0, 1e-12);
}

TEST(WaveOrders, OfCoggingAreOfTheMotorsAngle) {
  const WaveOrders orders = orders_of(
      [](const Made& at) { return 0.3 * std::sin(3.0 * MadeBench::kRatio * at.angle_rad + 0.4); });
  EXPECT_TRUE(holds(orders.motor, 3.0));
  EXPECT_TRUE(holds(orders.output, 30.0));  // the same, seen from the output
}

TEST(WaveOrders, OfRippleMayBeNoMultipleOfTheRatio) {
  const WaveOrders orders =
      orders_of([](const Made& at) { return 0.3 * std::sin(7.0 * at.angle_rad + 1.0); });
  EXPECT_TRUE(holds(orders.output, 7.0));
  EXPECT_TRUE(orders.motor.empty());
}

TEST(WaveOrders, OfRippleInProportionToTheLoad) {
  const WaveOrders orders = orders_of(
      [](const Made& at) { return 0.1 * at.torque_Nm * std::sin(5.0 * at.angle_rad + 1.0); });
  EXPECT_TRUE(holds(orders.load, 5.0));
  EXPECT_FALSE(holds(orders.output, 5.0));
}

TEST(WaveOrders, OfPositionDependentFriction) {
  const WaveOrders orders = orders_of([](const Made& at) {
    return -made::sign(at.speed_rad_s) * (0.6 + 0.4 * std::sin(2.0 * at.angle_rad));
  });
  EXPECT_TRUE(holds(orders.friction, 2.0));
}

// Friction, inertia and the torque constant are taken out first: beside ten times as much of them
// the wave's order is still the strongest peak, and no more than six are asked for.
TEST(WaveOrders, AreOfWhatSmoothEffectsLeave) {
  const WaveOrders orders = orders_of([](const Made& at) {
    return -2.0 * made::sign(at.speed_rad_s) - 0.5 * at.speed_rad_s + 0.2 * at.torque_Nm +
           0.2 * std::sin(7.0 * at.angle_rad);
  });
  EXPECT_TRUE(holds(orders.output, 7.0));
  EXPECT_LE(orders.motor.size(), 6u);
  EXPECT_LE(orders.output.size(), 6u);
}

}  // namespace
}  // namespace torquewright::identification::wave_orders_test
