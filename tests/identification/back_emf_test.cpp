// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "identification/forward/torque_prediction.hpp"
#include "identification/preparation/preparation.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::back_emf_test {
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

/// The balance of a stretch by a torque constant of so many times the stated one.
std::vector<double> balance_Nm(const Bench& bench, double factor, const Signals& signals) {
  Hypothesis hypothesis{bench.actuator(), *bench.rig, {}};
  hypothesis.actuator.motor.torque_constant_Nm_A *= factor;
  return torque_balance_Nm(bench, hypothesis, signals);
}

// Oracle: closed form, d/dk of N k Kt (V - k^share Ke N w) / R at k = 1. It is of second order in k
// at most, so that a central difference of any width is exact.
void expect_slope(std::optional<double> stated_V_s_rad, double back_emf_share) {
  const VoltageBench made(stated_V_s_rad);
  const Bench bench = made.bench(made.voltage_log);
  ASSERT_EQ(bench.drive, Drive::kVoltage);
  const Signals signals = prepare(made.voltage_log, bench, {}, PreparationOptions{}).front();
  const std::vector<double> less = balance_Nm(bench, 0.9, signals);
  const std::vector<double> more = balance_Nm(bench, 1.1, signals);
  const double constant = MadeBench::kTorqueConstant_Nm_A;
  for (std::size_t i = 50; i + 50 < signals.size(); i += 37) {
    const double back_emf_V = constant * MadeBench::kRatio * signals.at[i].speed_rad_s;
    const double slope_Nm = MadeBench::kRatio * constant / kResistance_ohm *
                            (signals.voltage_V[i] - (1.0 + back_emf_share) * back_emf_V);
    EXPECT_NEAR((less[i] - more[i]) / 0.2, slope_Nm, 1e-9) << i;
  }
}

TEST(BackEmf, FollowsTheTorqueConstantWhereTheDocumentStatesNone) {
  expect_slope(std::nullopt, 1.0);
}

TEST(BackEmf, ThatTheDocumentStatesDoesNotFollow) {
  expect_slope(MadeBench::kTorqueConstant_Nm_A, 0.0);
}

}  // namespace
}  // namespace torquewright::identification::back_emf_test
