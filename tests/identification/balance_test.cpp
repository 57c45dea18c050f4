// SPDX-License-Identifier: Apache-2.0
#include "identification/balance.hpp"

#include <gtest/gtest.h>

#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::balance_test {
namespace {

using made::MadeBench;

constexpr double kResistance_ohm = 0.5;

/// A bench with a torque sensor whose motor is driven by a voltage; its current is not logged.
struct VoltageBench : MadeBench {
  explicit VoltageBench(std::optional<double> back_emf_V_s_rad) {
    actuator.motor.torque_constant_convention = actuator::CurrentConvention::kDc;
    actuator.motor.resistance_convention = actuator::ResistanceConvention::kDc;
    actuator.motor.resistance_ohm = kResistance_ohm;
    actuator.motor.back_emf_constant_V_s_rad = back_emf_V_s_rad;
    voltage_log = log([](const made::Made&) { return 0.0; });
    for (std::size_t r = 0; r < kRuns; ++r) {
      voltage_log.runs.change(r, [](Run& run) {
        auto& joint = run.joints[0];
        joint[Quantity::kWindingVoltage] = joint[Quantity::kMotorCurrent];
        joint[Quantity::kMotorCurrent].clear();
      });
    }
  }

  Log voltage_log;
};

void expect_slope(std::optional<double> stated_V_s_rad, double back_emf_share) {
  const VoltageBench made(stated_V_s_rad);
  const Bench bench = made.bench(made.voltage_log);
  ASSERT_EQ(bench.drive, Drive::kVoltage);
  const Balance balance(bench);
  ASSERT_TRUE(balance.is_sensor());
  const Signals signals = prepare(made.voltage_log, bench, {}, PreparationOptions{}).front();
  const double constant = MadeBench::kTorqueConstant_Nm_A;
  for (std::size_t i = 50; i + 50 < signals.size(); i += 37) {
    const double back_emf_V = constant * MadeBench::kRatio * signals.at[i].speed_rad_s;
    const double voltage_V = kResistance_ohm * signals.at[i].current_A + back_emf_V;
    // d/dk of N k Kt (V - k^share Ke N w) / R at k = 1.
    const double slope_Nm = MadeBench::kRatio * constant / kResistance_ohm *
                            (voltage_V - (1.0 + back_emf_share) * back_emf_V);
    EXPECT_NEAR(balance.of_torque_constant_Nm(signals, i), slope_Nm, 1e-9) << i;
  }
}

TEST(Balance, BackEmfFollowsTheTorqueConstantWhereTheDocumentStatesNone) {
  expect_slope(std::nullopt, 1.0);
}

TEST(Balance, BackEmfThatTheDocumentStatesDoesNotFollow) {
  expect_slope(MadeBench::kTorqueConstant_Nm_A, 0.0);
}

}  // namespace
}  // namespace torquewright::identification::balance_test
