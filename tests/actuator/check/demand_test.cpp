// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/demand.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/library.hpp"
#include "tests/actuator/check/simple_actuator.hpp"

namespace torquewright::actuator {
namespace {

Demand demand(const Actuator& actuator, double speed_rad_s, double torque_Nm) {
  return *demand_at(actuator, phase_model_at(actuator, {}), kDefaultTemperature_K, speed_rad_s,
                    torque_Nm);
}

// Oracle: closed form of the dc motor: i = tau / (N Kt), V - R i - Ke N w, tau w + R i^2.
TEST(Demand, OfADcMotor) {
  const Actuator actuator = test::simple_actuator();
  for (const double speed_rad_s : {-20.0, 0.0, 7.0, 45.0}) {
    for (const double torque_Nm : {-25.0, 0.0, 12.0, 40.0}) {
      const Demand found = demand(actuator, speed_rad_s, torque_Nm);
      const double current_A = torque_Nm / 1.0;
      EXPECT_NEAR(found.current_A, std::abs(current_A), 1e-12);
      EXPECT_NEAR(found.bus_power_W, torque_Nm * speed_rad_s + 0.5 * current_A * current_A, 1e-10);
      EXPECT_NEAR(found.voltage_margin_V, 48.0 - std::abs(0.5 * current_A + speed_rad_s), 1e-12);
    }
  }
}

// Oracle: conservation. What the bus gives is what the load gets, what the copper takes, and what
// the gear and the drag take by the contract's order of losses, driving and driven back.
TEST(Demand, BalancesPowerWithGearLossesAndDrag) {
  Actuator actuator = test::simple_actuator();
  actuator.transmission.forward_efficiency = 0.9;
  actuator.transmission.backward_efficiency = 0.8;
  actuator.effects.push_back({find_effect("coulomb_friction"), {0.7}, {}, false, ""});
  for (const double torque_Nm : {15.0, -15.0}) {
    const double speed_rad_s = 6.0;
    const Demand found = demand(actuator, speed_rad_s, torque_Nm);
    const double before_Nm = torque_Nm > 0.0 ? torque_Nm / 0.9 : torque_Nm * 0.8;
    const double mesh_loss_W = (before_Nm - torque_Nm) * speed_rad_s;
    const double drag_W = 0.7 * speed_rad_s;
    const double copper_W = 0.5 * found.current_A * found.current_A;
    EXPECT_GT(mesh_loss_W, 0.0);
    EXPECT_NEAR(found.bus_power_W, torque_Nm * speed_rad_s + mesh_loss_W + drag_W + copper_W,
                1e-10);
  }
}

// Oracle: closed form. At rest 0.7 Nm of friction hold as much of the load; a smaller load needs
// nothing at all.
TEST(Demand, FrictionHoldsAtRest) {
  Actuator actuator = test::simple_actuator();
  actuator.effects.push_back({find_effect("coulomb_friction"), {0.7}, {}, false, ""});
  EXPECT_NEAR(demand(actuator, 0.0, 10.0).current_A, 9.3, 1e-12);
  EXPECT_NEAR(demand(actuator, 0.0, -10.0).current_A, 9.3, 1e-12);
  EXPECT_EQ(demand(actuator, 0.0, 0.5).current_A, 0.0);
  EXPECT_EQ(demand(actuator, 0.0, 0.0).current_A, 0.0);
}

TEST(Demand, IsEmptyWhereSaturationYieldsNoTorque) {
  Actuator actuator = test::simple_actuator();
  actuator.effects.push_back(
      {find_effect("torque_constant_saturation"), {20.0, 2.0}, {}, false, ""});
  const PhaseModel model = phase_model_at(actuator, {});
  EXPECT_TRUE(demand_at(actuator, model, kDefaultTemperature_K, 0.0, 19.9).has_value());
  EXPECT_FALSE(demand_at(actuator, model, kDefaultTemperature_K, 0.0, 20.1).has_value());
}

}  // namespace
}  // namespace torquewright::actuator
