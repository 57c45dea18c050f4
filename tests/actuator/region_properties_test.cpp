// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/region/joint_region.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::actuator {
namespace {

constexpr unsigned kActuators = 10000;
constexpr double kShares[] = {-1.3, -0.7, -0.2, 0.1, 0.5, 0.9, 1.2};  // of the no-load speed

double joint_no_load_rad_s(const Region& region, const Actuator& actuator) {
  return no_load_speed_rad_s(region.model()) / std::abs(actuator.transmission.ratio);
}

double scale_Nm(const Actuator& actuator, const Region& region) {
  return std::abs(actuator.transmission.ratio) * region.model().torque_constant_Nm_A *
         region.model().current_limit_A;
}

// Oracle: the definition. Up to no-load speed zero current is allowed, and the range of the motor
// contains its torque, zero; everything between its bounds is allowed (one interval).
TEST(RegionProperty, IsOneIntervalThatHoldsZeroCurrentUpToNoLoad) {
  for (unsigned seed = 0; seed < kActuators; ++seed) {
    RandomActuatorOptions options;
    options.field_weakening = seed % 50 == 0;
    const PhaseModel model = phase_model_at(random_actuator(seed, options), {});
    for (const double share : kShares) {
      const double w = share * no_load_speed_rad_s(model);
      const MotorRange range = motor_range(model, w);
      if (std::abs(share) < 1.0) {
        ASSERT_FALSE(range.is_empty) << seed;
        EXPECT_LE(range.least.torque_Nm, 0.0) << seed;
        EXPECT_GE(range.greatest.torque_Nm, 0.0) << seed;
      }
      if (range.is_empty) continue;
      const double tolerance_V = 1e-9 * model.supply.open_circuit_V;
      for (const double part : {0.1, 0.5, 0.9}) {
        const double torque_Nm =
            range.least.torque_Nm + part * (range.greatest.torque_Nm - range.least.torque_Nm);
        const MotorBound point = motor_point(model, torque_Nm, w, Limiter::kCurrent);
        EXPECT_GE(voltage_margin_V(model, point.current, w), -tolerance_V) << seed;
        EXPECT_LE(point.current.amplitude_A(), model.current_limit_A * (1.0 + 1e-9)) << seed;
        EXPECT_GE(point.bus_power_W, model.supply.least_power_W - 1e-6) << seed;
      }
    }
  }
}

// More voltage never hurts where nothing caps the charge.
TEST(RegionProperty, GrowsWithTheBusVoltage) {
  for (unsigned seed = 0; seed < kActuators; ++seed) {
    RandomActuatorOptions options;
    options.regeneration_limits = false;
    options.field_weakening = seed % 50 == 0;
    Actuator actuator = random_actuator(seed, options);
    if (actuator.battery) actuator.battery->discharge_limit_A = kUnlimited;
    const Region region(actuator, {});
    OperatingConditions more;
    more.bus_voltage_V = 1.1 * open_circuit_voltage_V(actuator, {});
    const Region larger(actuator, more);
    const double tolerance_Nm = 1e-9 * scale_Nm(actuator, region);
    for (const double share : kShares) {
      const double w = share * joint_no_load_rad_s(region, actuator);
      const JointRange inner = region.at(w);
      if (inner.is_empty) continue;
      const JointRange outer = larger.at(w);
      ASSERT_FALSE(outer.is_empty) << seed;
      EXPECT_LE(outer.least.torque_Nm, inner.least.torque_Nm + tolerance_Nm)
          << seed << " " << share;
      EXPECT_GE(outer.greatest.torque_Nm, inner.greatest.torque_Nm - tolerance_Nm)
          << seed << " " << share;
    }
  }
}

TEST(RegionProperty, IsUnchangedByNeutralEffects) {
  for (unsigned seed = 0; seed < kActuators; seed += 10) {
    RandomActuatorOptions options;
    options.with_effects = false;
    const Actuator plain = random_actuator(seed, options);
    Actuator burdened = plain;
    for (const EffectKind* kind : effect_library()) {
      if (kind->acts == Acts::kResistanceFactor) continue;  // takes copper's own coefficient away
      burdened.effects.push_back(neutral(*kind));
    }
    const Region before(plain, {});
    const Region after(burdened, {});
    for (const double share : kShares) {
      const double w = share * joint_no_load_rad_s(before, plain);
      const JointRange one = before.at(w);
      const JointRange other = after.at(w);
      ASSERT_EQ(one.is_empty, other.is_empty) << seed;
      EXPECT_EQ(one.greatest.torque_Nm, other.greatest.torque_Nm) << seed;
      EXPECT_EQ(one.least.torque_Nm, other.least.torque_Nm) << seed;
    }
  }
}

// Oracle: without losses the joint's region is the rotor's, speed over ratio and torque times
// ratio.
TEST(RegionProperty, AgreesBetweenMotorAndJoint) {
  for (unsigned seed = 0; seed < kActuators; seed += 5) {
    RandomActuatorOptions options;
    options.with_effects = false;
    Actuator actuator = random_actuator(seed, options);
    actuator.transmission.forward_efficiency = actuator.transmission.backward_efficiency = 1.0;
    actuator.transmission.ratio = std::abs(actuator.transmission.ratio);
    const double ratio = actuator.transmission.ratio;
    const Region joint(actuator, {});
    const Region motor(actuator, {}, Side::kMotor);
    const double tolerance_Nm = 1e-9 * scale_Nm(actuator, joint);
    for (const double share : kShares) {
      const double w = share * joint_no_load_rad_s(joint, actuator);
      const JointRange at_joint = joint.at(w);
      const JointRange at_motor = motor.at(w * ratio);
      ASSERT_EQ(at_joint.is_empty, at_motor.is_empty) << seed;
      if (at_joint.is_empty) continue;
      EXPECT_NEAR(at_joint.greatest.torque_Nm, ratio * at_motor.greatest.torque_Nm, tolerance_Nm);
      EXPECT_NEAR(at_joint.least.torque_Nm, ratio * at_motor.least.torque_Nm, tolerance_Nm);
      EXPECT_EQ(at_joint.greatest.limiter, at_motor.greatest.limiter) << seed;
    }
  }
}

}  // namespace
}  // namespace torquewright::actuator
