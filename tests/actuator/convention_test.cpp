// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/convention.hpp"

#include <gtest/gtest.h>

#include "actuator/region/motor_region.hpp"
#include "actuator/region/operating_conditions.hpp"

namespace torquewright::actuator {
namespace {

struct TableTwoRow {
  CurrentConvention convention;
  Modulation modulation;
  double knee_rad_s;   // D151: Kt 0.32, ratio 20
  double ankle_rad_s;  // D110A: Kt 0.44, ratio 8
};

// Oracle: no-load speeds c V/(Kt N) of table II of seed 001 at 67.2 V under each convention, as the
// reference lists them (section 2.3, printed to 0.01 rad/s).
constexpr TableTwoRow kTableTwo[] = {
    {CurrentConvention::kDc, Modulation::kSvpwm, 10.50, 19.09},
    {CurrentConvention::kPeakPhase, Modulation::kSvpwm, 9.09, 16.53},
    {CurrentConvention::kPeakPhase, Modulation::kSine, 7.88, 14.32},
    {CurrentConvention::kPeakPhase, Modulation::kSixStep, 10.03, 18.23},
    {CurrentConvention::kRmsPhase, Modulation::kSvpwm, 12.86, 23.38},
    {CurrentConvention::kRmsPhase, Modulation::kSine, 11.14, 20.25},
};

double no_load_rad_s(double torque_constant_Nm_A, double ratio, const TableTwoRow& row) {
  Actuator actuator;
  actuator.motor.torque_constant_Nm_A = torque_constant_Nm_A;
  actuator.motor.torque_constant_convention = row.convention;
  actuator.motor.resistance_ohm = 0.3;
  actuator.drive.bus_voltage_V = 67.2;
  actuator.drive.peak_current_A = 50.0;
  actuator.drive.modulation = row.modulation;
  return no_load_speed_rad_s(phase_model_at(actuator, {})) / ratio;
}

TEST(Conventions, GiveTheNoLoadSpeedsOfTableTwo) {
  for (const TableTwoRow& row : kTableTwo) {
    EXPECT_NEAR(no_load_rad_s(0.32, 20.0, row), row.knee_rad_s, 0.00501) << name_of(row.convention);
    EXPECT_NEAR(no_load_rad_s(0.44, 8.0, row), row.ankle_rad_s, 0.00501) << name_of(row.convention);
  }
}

// Oracle: conservation of power. An ideal model turns electrical into mechanical power, 1.5 e i
// per phase amplitudes, whatever ampere its torque constant counts.
TEST(Conventions, ConservePower) {
  for (const auto convention :
       {CurrentConvention::kDc, CurrentConvention::kPeakPhase, CurrentConvention::kRmsPhase}) {
    const double phase_Nm_A = 1.0 / phase_amperes_per_ampere(convention);
    const double phase_V_s =
        back_emf_per_torque_constant(convention) * phase_volts_per_winding_volt(convention);
    EXPECT_NEAR(1.5 * phase_V_s, phase_Nm_A, 1e-15) << name_of(convention);
  }
}

// Oracle: copper loss R i^2 of the equivalent winding equals three phases' R i_rms^2.
TEST(Conventions, KeepTheCopperLossOfTheEquivalentWinding) {
  const double phase_A = phase_amperes_per_ampere(CurrentConvention::kDc);
  EXPECT_NEAR(1.5 * phase_ohms_per_ohm(ResistanceConvention::kDc) * phase_A * phase_A, 1.0, 1e-15);
}

// Oracle: 8.270/Kv[rpm/V] is the torque constant per peak phase ampere (reference, section 2.1).
TEST(Conventions, AgreeWithTheVelocityConstant) {
  const double rad_s_per_rpm = 3.14159265358979323846 / 30.0;
  const double velocity_constant_rad_s_V = 100.0 * rad_s_per_rpm;
  const double dc_Nm_A = 1.0 / velocity_constant_rad_s_V;
  EXPECT_NEAR(dc_Nm_A / phase_amperes_per_ampere(CurrentConvention::kDc), 8.270 / 100.0, 5e-6);
}

}  // namespace
}  // namespace torquewright::actuator
