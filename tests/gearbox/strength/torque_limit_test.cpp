// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/torque_limit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/gearbox/strength/example_strength.hpp"

namespace torquewright::gearbox {
namespace {

/// Oracle: halving, from the stresses alone.
double bracketed_limit_Nm(const StrengthCase& strength, bool once) {
  double low = 0;
  double high = 1e5;
  for (int step = 0; step < 100; ++step) {
    const double middle = (low + high) / 2;
    bool is_borne = true;
    for (const ToothLoad& load : tooth_loads(strength, middle)) {
      const double root = once ? load.root.static_safety() : load.root.life_safety();
      const double flank = once ? load.flank.static_safety() : load.flank.life_safety();
      is_borne = is_borne && root >= strength.demanded_root_safety &&
                 flank >= strength.demanded_flank_safety;
    }
    (is_borne ? low : high) = middle;
  }
  return low;
}

StrengthCase random_case(std::mt19937& random) {
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  StrengthCase strength = draw(0, 1) < .5 ? test::d110a_strength() : test::d151_strength();
  for (double& width_mm : strength.train.face_width_mm) width_mm = draw(3, 30);
  strength.factors = {draw(.5, 2), draw(1, 2), draw(1, 2), draw(1, 2), draw(1, 2), draw(.5, 1)};
  strength.material.contact_endurance_MPa = draw(400, 3000);
  strength.cycles = std::pow(10.0, draw(0, 9));
  strength.demanded_root_safety = draw(.5, 3);
  strength.demanded_flank_safety = draw(.5, 3);
  return strength;
}

TEST(TorqueLimits, AreWhereHalvingFindsThem) {
  std::mt19937 random(11);
  int bending = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const StrengthCase strength = random_case(random);
    const TorqueLimits limits = torque_limits(strength);
    EXPECT_NEAR(limits.once.motor_Nm / bracketed_limit_Nm(strength, true), 1, 1e-9);
    EXPECT_NEAR(limits.for_cycles.motor_Nm / bracketed_limit_Nm(strength, false), 1, 1e-9);
    EXPECT_LE(limits.for_cycles.motor_Nm, limits.once.motor_Nm);
    bending += limits.once.mode == FailureMode::kBending ? 1 : 0;
  }
  EXPECT_GT(bending, 20);  // both modes were met
  EXPECT_LT(bending, 180);
}

// At the limit the named gear's named stress is the one that has just the demanded safety.
TEST(TorqueLimits, NameTheGearAndTheMode) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 100; ++trial) {
    const StrengthCase strength = random_case(random);
    const TorqueLimit limit = torque_limits(strength).for_cycles;
    const auto loads = tooth_loads(strength, limit.motor_Nm);
    const auto named = std::find_if(loads.begin(), loads.end(), [&](const ToothLoad& load) {
      return load.gear == limit.gear && load.mesh == limit.mesh;
    });
    ASSERT_NE(named, loads.end());
    const bool bends = limit.mode == FailureMode::kBending;
    const ToothStress& stress = bends ? named->root : named->flank;
    EXPECT_NEAR(stress.life_safety(),
                bends ? strength.demanded_root_safety : strength.demanded_flank_safety, 1e-9);
  }
}

// 8 and 20: the joint's torque is the motor's times the published ratios.
TEST(TorqueLimits, StandOnBothSides) {
  const TorqueLimit ankle = torque_limits(test::d110a_strength()).once;
  EXPECT_NEAR(ankle.joint_Nm, 8 * ankle.motor_Nm, 1e-9);
  const TorqueLimit knee = torque_limits(test::d151_strength()).once;
  EXPECT_NEAR(knee.joint_Nm, 20 * knee.motor_Nm, 1e-9);
}

}  // namespace
}  // namespace torquewright::gearbox
