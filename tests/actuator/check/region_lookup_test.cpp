// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/region_lookup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "actuator/effects/library.hpp"
#include "tests/actuator/check/simple_actuator.hpp"

namespace torquewright::actuator {
namespace {

/// Friction, sag, inductance and field weakening: curved bounds with many corners.
Actuator curved_actuator() {
  Actuator actuator = test::simple_actuator();
  actuator.motor.inductance_d_H = 3e-4;
  actuator.motor.inductance_q_H = 3e-4;
  actuator.motor.pole_pairs = 14;
  actuator.drive.field_weakening = true;
  actuator.transmission.forward_efficiency = 0.9;
  actuator.transmission.backward_efficiency = 0.85;
  actuator.effects.push_back({find_effect("coulomb_friction"), {0.8}, {}, false, ""});
  Battery battery;
  battery.series_cells = 12;
  battery.cell_open_circuit = {{1.0, 4.0}};
  battery.cell_resistance_ohm = 0.015;
  actuator.battery = battery;
  return actuator;
}

// Oracle: the region itself. 10000 samples, half of them within 1e-3 of a bound, where only an
// exact evaluation can tell inside from outside.
TEST(RegionLookup, JudgesAsTheRegionItselfDoes) {
  for (const Actuator& actuator : {test::simple_actuator(), curved_actuator()}) {
    const RegionLookup lookup(actuator, {});
    const double end_rad_s = lookup.greatest_speed_rad_s();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    int outside = 0;
    for (int i = 0; i < 5000; ++i) {
      const double speed_rad_s = 1.1 * end_rad_s * share(random);
      const JointRange range = lookup.exact(speed_rad_s);
      const double bound_Nm = i % 4 < 2 ? range.greatest.torque_Nm : range.least.torque_Nm;
      const double torque_Nm =
          i % 2 == 0 ? 60.0 * share(random) : bound_Nm * (1.0 + 1e-3 * share(random));
      const bool truth = range.is_empty ||
                         torque_Nm > range.greatest.torque_Nm + lookup.round_off_Nm() ||
                         torque_Nm < range.least.torque_Nm - lookup.round_off_Nm();
      const TorqueRange found = lookup.at(speed_rad_s, torque_Nm);
      ASSERT_EQ(lookup.is_outside(found, torque_Nm), truth) << speed_rad_s << " " << torque_Nm;
      outside += truth ? 1 : 0;
    }
    EXPECT_GT(outside, 1000);
    EXPECT_LT(outside, 4000);
  }
}

// Oracle: the region itself, which has no row to look up beyond the table's ends.
TEST(RegionLookup, AsksTheRegionBeyondItsTable) {
  const RegionLookup lookup(test::simple_actuator(), {});
  const double beyond_rad_s = 1.5 * lookup.greatest_speed_rad_s();
  for (const double speed_rad_s : {-beyond_rad_s, beyond_rad_s}) {
    EXPECT_EQ(lookup.near(speed_rad_s).is_empty, lookup.exact(speed_rad_s).is_empty);
  }
}

TEST(RegionLookup, TakesTheUnionAtRest) {
  const RegionLookup lookup(curved_actuator(), {});
  const TorqueRange rest = lookup.near(0.0);
  const JointRange truth = lookup.exact(0.0);
  EXPECT_EQ(rest.least_Nm, truth.least.torque_Nm);
  EXPECT_EQ(rest.greatest_Nm, truth.greatest.torque_Nm);
  EXPECT_GT(rest.greatest_Nm, lookup.near(1e-6).greatest_Nm + 1.0);
}

// Oracle: closed form. With K = N Kt the torque tau is there up to V/K - R tau / K^2: for the
// simple actuator 48 - tau / 2 rad/s; above the cap of 30 Nm at no speed.
TEST(RegionLookup, SpeedMarginIsTheDistanceToTheVoltageLine) {
  const RegionLookup lookup(test::simple_actuator(), {});
  const double tolerance_rad_s = 1e-6;
  EXPECT_NEAR(lookup.speed_margin_rad_s(10.0, 20.0), 38.0 - 10.0, tolerance_rad_s);
  EXPECT_NEAR(lookup.speed_margin_rad_s(-10.0, -20.0), 38.0 - 10.0, tolerance_rad_s);
  EXPECT_NEAR(lookup.speed_margin_rad_s(0.0, 30.0), 33.0, tolerance_rad_s);
  EXPECT_NEAR(lookup.speed_margin_rad_s(45.0, 20.0), 38.0 - 45.0, tolerance_rad_s);
  EXPECT_NEAR(lookup.speed_margin_rad_s(1e4, 20.0), 38.0 - 1e4, tolerance_rad_s);
  EXPECT_EQ(lookup.speed_margin_rad_s(10.0, 31.0), -kUnlimited);
  // Braking, the back-EMF helps: -20 Nm is there up to 48 + 10 rad/s.
  EXPECT_NEAR(lookup.speed_margin_rad_s(10.0, -20.0), 58.0 - 10.0, tolerance_rad_s);
}

// Oracle: the search that is not cut short.
TEST(RegionLookup, SpeedMarginEndsWhereItIsKnownToBeNoLess) {
  const RegionLookup lookup(curved_actuator(), {});
  const double greatest_rad_s = lookup.greatest_speed_rad_s();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.5, 1.5);
  for (int i = 0; i < 2000; ++i) {
    const double speed_rad_s = share(random) * greatest_rad_s;
    const double torque_Nm = share(random) * lookup.near(0.0).greatest_Nm;
    const double at_most_rad_s = share(random) * greatest_rad_s;
    EXPECT_EQ(lookup.speed_margin_rad_s(speed_rad_s, torque_Nm, at_most_rad_s),
              std::min(lookup.speed_margin_rad_s(speed_rad_s, torque_Nm), at_most_rad_s));
  }
}

TEST(RegionLookup, ComparesSpeedMarginsAsItComputesThem) {
  const RegionLookup lookup(curved_actuator(), {});
  std::mt19937 random(4);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const double speed_rad_s = lookup.greatest_speed_rad_s() * share(random);
    const double torque_Nm = 25.0 * share(random);
    const double margin_rad_s = lookup.speed_margin_rad_s(speed_rad_s, torque_Nm);
    if (!std::isfinite(margin_rad_s)) continue;
    EXPECT_FALSE(lookup.has_less_speed_margin(speed_rad_s, torque_Nm, margin_rad_s - 1e-3));
    if (std::abs(speed_rad_s) + margin_rad_s + 1e-3 > lookup.greatest_speed_rad_s()) continue;
    EXPECT_TRUE(lookup.has_less_speed_margin(speed_rad_s, torque_Nm, margin_rad_s + 1e-3));
  }
}

}  // namespace
}  // namespace torquewright::actuator
