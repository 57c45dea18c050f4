// SPDX-License-Identifier: Apache-2.0
// Oracle: a dc winding by hand, K = 0.05 Nm/A, R = 0.2 ohm, 48 V, 30 A behind 10:1 without losses:
// 10 K I = 15 Nm up to (V - R I)/(10 K) = 84 rad/s, torque ends at V/(10 K) = 96 rad/s.
#include "actuator/winding/winding_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::actuator {
namespace {

constexpr double kConstant_Nm_A = 0.05, kResistance_ohm = 0.2, kVoltage_V = 48.0, kCurrent_A = 30.0;

Actuator curve(bool ends = true) {
  Actuator actuator;
  actuator.name = "curve";
  actuator.transmission.ratio = 10.0;
  Envelope envelope;
  envelope.ratio = 10.0;
  envelope.includes_losses = false;
  envelope.peak.greatest = {{-96.0, 15.0}, {84.0, 15.0}};
  if (ends) envelope.peak.greatest.push_back({96.0, 0.0});
  envelope.peak.least = {{-96.0, -15.0}, {96.0, -15.0}};
  actuator.envelope = envelope;
  return actuator;
}

bool holds(const WindingInterval& interval, double value) {
  return interval.low <= value * (1.0 + 1e-9) && value <= interval.high * (1.0 + 1e-9);
}

void expect_truth(const WindingEstimate& found) {
  EXPECT_EQ(found.contradiction, "");
  EXPECT_TRUE(holds(found.torque_constant_Nm_A, kConstant_Nm_A));
  EXPECT_TRUE(holds(found.resistance_ohm, kResistance_ohm));
  EXPECT_TRUE(holds(found.voltage_V, kVoltage_V));
  EXPECT_TRUE(holds(found.current_A, kCurrent_A));
  EXPECT_FALSE(found.rests_on.empty());
}

// Any two of the four: the rest is there, and no wider than the digits of what is stated.
TEST(WindingEstimate, HoldsTheWindingWhicheverTwoAreKnown) {
  for (int one = 0; one < 4; ++one) {
    for (int other = one + 1; other < 4; ++other) {
      const auto is_known = [&](int i) { return i == one || i == other; };
      KnownWinding known;
      if (is_known(0)) known.torque_constant_Nm_A = kConstant_Nm_A;
      if (is_known(1)) known.resistance_ohm = kResistance_ohm;
      if (is_known(2)) known.voltage_V = kVoltage_V;
      if (is_known(3)) known.current_A = kCurrent_A;
      SCOPED_TRACE(::testing::Message() << one << " and " << other);
      const WindingEstimate found = winding_estimate(curve(), known);
      expect_truth(found);
      EXPECT_LT(found.torque_constant_Nm_A.high, 1.3 * found.torque_constant_Nm_A.low);
      EXPECT_LT(found.voltage_V.high, 1.3 * found.voltage_V.low);
      EXPECT_TRUE(std::isfinite(found.resistance_ohm.high));
    }
  }
}

TEST(WindingEstimate, NamesWhatCannotBeTogether) {
  KnownWinding known;
  known.torque_constant_Nm_A = kConstant_Nm_A;
  known.voltage_V = 24.0;  // half of what 96 rad/s ask for
  const WindingEstimate found = winding_estimate(curve(), known);
  EXPECT_NE(found.contradiction.find("torque constant and voltage"), std::string::npos);
}

// A curve that stops for another reason says only what the voltage must reach.
TEST(WindingEstimate, BoundsOnOneSideWhereTorqueDoesNotEnd) {
  KnownWinding known;
  known.torque_constant_Nm_A = kConstant_Nm_A;
  known.current_A = kCurrent_A;
  const WindingEstimate found = winding_estimate(curve(false), known);
  EXPECT_EQ(found.contradiction, "");
  EXPECT_GE(found.voltage_V.low, 0.9 * 10.0 * kConstant_Nm_A * 84.0);
  EXPECT_TRUE(std::isinf(found.voltage_V.high));
  EXPECT_EQ(found.resistance_ohm.low, 0.0);
}

// Two numbers make a line from rest; where the current's limit ends on it nobody knows: R I up to
// V.
TEST(WindingEstimate, BoundsTheResistanceFromOneSideWithoutACorner) {
  Actuator line = curve();
  line.envelope->peak.greatest = {{0.0, 15.0}, {96.0, 0.0}};
  KnownWinding known;
  known.voltage_V = kVoltage_V;
  known.current_A = kCurrent_A;
  const WindingEstimate found = winding_estimate(line, known);
  expect_truth(found);
  EXPECT_EQ(found.resistance_ohm.low, 0.0);
  EXPECT_GE(found.resistance_ohm.high, kVoltage_V / kCurrent_A);
  EXPECT_LE(found.resistance_ohm.high, 48.5 / 29.5 * (1.0 + 1e-9));  // by their digits
}

// Losses of gears that the curve holds: up to a tenth of the torque for a stage.
TEST(WindingEstimate, LeavesOpenWhatGearsTake) {
  Actuator geared = curve();
  geared.envelope->includes_losses = true;
  KnownWinding known;
  known.torque_constant_Nm_A = kConstant_Nm_A;
  known.voltage_V = kVoltage_V;
  const WindingEstimate found = winding_estimate(geared, known);
  EXPECT_TRUE(holds(found.current_A, kCurrent_A));
  EXPECT_TRUE(holds(found.current_A, kCurrent_A / 0.9));
}

}  // namespace
}  // namespace torquewright::actuator
