// SPDX-License-Identifier: Apache-2.0
// Published motors: what their tables contradict, and by how much.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kPrintedRatio = 0.005;  ///< Half a unit of the oracle's last decimal.
constexpr double kRadPerRpm_s = std::numbers::pi / 30.0;

Actuator bare_motor(const char* name, double volts) {
  Actuator document;
  document.name = name;
  document.drive.bus_voltage_V = volts;
  document.motor.resistance_ohm = 0.1;  // none is printed: any that motors have
  document.datasheet = Datasheet{};
  return document;
}

/// WPILib DCMotor (BSD licence): 12 V, stall torque and current, free current and speed; R = V / Is
/// and Kt = Ts / Is. Oracle: Kt / Ke with Ke = (V - R I0) / w, computed apart.
struct FreeMotor {
  const char* name;
  double stall_torque_Nm, stall_current_A, free_current_A, free_speed_rpm, ratio_of_constants;
};

Actuator document_of(const FreeMotor& motor) {
  Actuator document = bare_motor(motor.name, 12);
  document.motor.torque_constant_Nm_A = motor.stall_torque_Nm / motor.stall_current_A;
  document.motor.resistance_ohm = 12 / motor.stall_current_A;
  document.datasheet->stall_torque_Nm = motor.stall_torque_Nm;
  document.datasheet->stall_current_A = motor.stall_current_A;
  document.datasheet->no_load_current_A = motor.free_current_A;
  document.datasheet->no_load_speed_rad_s = motor.free_speed_rpm * kRadPerRpm_s;
  return document;
}

class FreeMotors : public testing::TestWithParam<FreeMotor> {};

TEST_P(FreeMotors, HaveTorqueAndSpeedOfDifferentConstants) {
  const Actuator document = document_of(GetParam());
  EXPECT_TRUE(comparison(document, "stall-torque")->agrees);
  EXPECT_TRUE(comparison(document, "stall-current")->agrees);
  const auto speed = finding(document, "no-load-speed");
  ASSERT_TRUE(speed);
  EXPECT_NEAR(speed->stated.value / speed->expected.value, GetParam().ratio_of_constants,
              kPrintedRatio);
}

INSTANTIATE_TEST_SUITE_P(Wpilib, FreeMotors,
                         testing::Values(FreeMotor{"CIM", 2.42, 133, 2.7, 5310, 0.86},
                                         FreeMotor{"NEO", 2.6, 105, 1.8, 5676, 1.25},
                                         FreeMotor{"NEO 550", 0.97, 100, 1.4, 11000, 0.94},
                                         FreeMotor{"Falcon 500", 4.69, 257, 1.5, 6380, 1.02},
                                         FreeMotor{"775pro", 0.71, 134, 0.7, 18730, 0.87}),
                         [](const auto& row) { return "motor_" + std::to_string(row.index); });

// The brushed ones of that table print the stall's torque per ampere, of which saturation has taken
// a share, beside a free speed of the whole flux: sound. Beyond 0.9 times 0.8 they would not be,
// nor is a torque constant over or times sqrt(3), which then is no longer the stall's.
TEST(BrushedMotors, AreSoundAsTheirTablesPrintThem) {
  for (const FreeMotor& motor :
       {FreeMotor{"CIM", 2.42, 133, 2.7, 5310, 0}, FreeMotor{"MiniCIM", 1.41, 89, 3, 5840, 0},
        FreeMotor{"BAG", 0.43, 53, 1.8, 13180, 0}, FreeMotor{"775pro", 0.71, 134, 0.7, 18730, 0},
        FreeMotor{"Andymark RS775-125", 0.28, 18, 1.6, 5800, 0},
        FreeMotor{"Banebots RS775", 0.72, 97, 2.7, 13050, 0}}) {
    Actuator document = document_of(motor);
    EXPECT_FALSE(has_contradiction(examine_all(std::vector{document}))) << motor.name;
    for (const double factor : {std::sqrt(3.0), 1.0 / std::sqrt(3.0)}) {
      Actuator other = document;
      other.motor.torque_constant_Nm_A *= factor;
      EXPECT_TRUE(has_contradiction(examine_all(std::vector{other}))) << motor.name << factor;
    }
    const double speed_rad_s = comparison(document, "no-load-speed")->expected.value;
    document.datasheet->no_load_speed_rad_s = 0.7 * speed_rad_s;
    EXPECT_TRUE(has_contradiction(examine_all(std::vector{document}))) << motor.name;
  }
}

/// LKTech MG series, maker's table on a shop page: torque constant over ratio, speed constant of
/// the bare motor. Oracle: Kt / Ke, computed apart; sqrt(3) is Nm per rms ampere over line-to-line
/// rms.
struct ShopMotor {
  const char* name;
  double torque_constant_Nm_A, speed_constant_rpm_V, ratio_of_constants;
};
constexpr ShopMotor kShopMotors[] = {
    {"MG6012-8", 0.165, 58, 1.00}, {"MG8008-9", 0.23, 42, 1.01}, {"MG10015-10", 0.385, 28, 1.13},
    {"MG6010-6", 0.22, 58, 1.34},  {"MG8010-6", 0.5, 32, 1.68},  {"MG8016-6", 0.55, 30, 1.73},
};

Actuator document_of(const ShopMotor& motor) {
  Actuator document = bare_motor(motor.name, 48);
  document.motor.torque_constant_Nm_A = motor.torque_constant_Nm_A;
  document.datasheet->velocity_constant_rpm_V = motor.speed_constant_rpm_V;
  return document;
}

TEST(ShopMotors, HaveSpeedConstantsOfSeveralConventions) {
  for (const ShopMotor& motor : kShopMotors) {
    const auto row = comparison(document_of(motor), "velocity-constant");
    ASSERT_TRUE(row);
    EXPECT_NEAR(row->stated.value / row->expected.value, motor.ratio_of_constants, kPrintedRatio)
        << motor.name;
    EXPECT_EQ(row->agrees, motor.ratio_of_constants < 1.1) << motor.name;
  }
}

TEST(ShopMotors, AreReconciledByTheRmsConventionWhereTheRatioIsRootThree) {
  const auto speed = finding(document_of(kShopMotors[5]), "velocity-constant");
  ASSERT_TRUE(speed);
  const auto rms =
      explanation(*speed, "torque constant per rms ampere, back-EMF as line-to-line rms");
  EXPECT_EQ(rms.fit, Agreement::kFits);
  EXPECT_NEAR(rms.expected->value / speed->expected.value, std::numbers::sqrt3, 1e-12);
}

TEST(ShopMotors, HaveOneThatNoConventionReconciles) {
  const auto speed = finding(document_of(kShopMotors[2]), "velocity-constant");
  ASSERT_TRUE(speed);
  EXPECT_EQ(speed->severity, Severity::kViolation) << speed->sentence;
}

/// RaiSim 2's documentation: R 0.2, Kt 0.1, Kv 10 rad/s/V, 24 V, 1.5 Nm, 10:1: 15 Nm, 240 rad/s.
TEST(RaisimDocument, IsConsistent) {
  Actuator document = bare_motor("raisim 2", 24);
  document.motor.torque_constant_Nm_A = 0.1;
  document.motor.back_emf_constant_V_s_rad = 0.1;
  document.motor.resistance_ohm = 0.2;
  document.transmission.ratio = 10;
  document.drive.peak_current_A = 15;
  document.datasheet->joint_side = true;
  document.datasheet->peak_torque_Nm = 15;
  document.datasheet->no_load_speed_rad_s = 24;
  for (const Finding& finding : examine(document).findings) EXPECT_EQ(finding.rule, "few-digits");
  EXPECT_NEAR(comparison(document, "peak-torque")->expected.value, 15, 1e-12 * 15);
  EXPECT_NEAR(comparison(document, "no-load-speed")->expected.value, 24, 1e-12 * 24);
}

/// GO-M8010-6 at 24 V as digitised by a third party: rotor rpm = 1746.5 - 200.2 torque, 6.33:1; so
/// no-load 28.9 rad/s and stall 55.2 Nm at the joint. The maker's own model of the robot that uses
/// it extrapolates to 36.7 Nm.
TEST(GoMotor, AgreesWithItsOwnLineOnly) {
  Actuator document = bare_motor("GO-M8010-6", 24);
  const double no_load_rad_s = 1746.5 * kRadPerRpm_s;
  const double slope_rad_s_Nm = 200.2 * kRadPerRpm_s;
  const double constant = 24 / no_load_rad_s;
  document.motor.torque_constant_Nm_A = constant;
  document.motor.resistance_ohm = slope_rad_s_Nm * constant * constant;
  document.transmission.ratio = 6.33;
  document.datasheet->joint_side = true;
  document.datasheet->no_load_speed_rad_s = 28.9;
  document.datasheet->stall_torque_Nm = 55.2;
  EXPECT_TRUE(examine(document).findings.empty());
  document.datasheet->stall_torque_Nm = 36.7;
  EXPECT_TRUE(finding(document, "stall-torque"));
}

/// Unitree's presets M107: Y1 driving and Y2 braking 150 and 182.8 Nm (15:1), 240 and 292.5 (24:1);
/// no-load 25.6 and 16 rad/s; armature 0.063259741 and 0.160478022.
Actuator m107(double ratio, double driving_Nm, double braking_Nm, double speed_rad_s,
              double armature_kg_m2) {
  Actuator document = bare_motor("M107", 48);
  document.name += "-" + std::to_string(static_cast<int>(ratio));
  document.motor.torque_constant_Nm_A = 0.125;
  document.transmission.ratio = ratio;
  document.transmission.forward_efficiency = 0.906;
  document.transmission.backward_efficiency = 0.906;
  document.datasheet->joint_side = true;
  document.datasheet->peak_torque_Nm = driving_Nm;
  document.datasheet->peak_braking_torque_Nm = braking_Nm;
  document.datasheet->no_load_speed_rad_s = speed_rad_s;
  document.datasheet->reflected_inertia_kg_m2 = armature_kg_m2;
  return document;
}

TEST(M107, BrakesWithTheEfficienciesThatItDrivesWith) {
  Actuator slow = m107(24, 240, 292.5, 16, 0.160478022);
  EXPECT_TRUE(comparison(slow, "peak-braking-torque")->agrees);
  slow.transmission.forward_efficiency = slow.transmission.backward_efficiency = 0.912;
  EXPECT_FALSE(comparison(slow, "peak-braking-torque")->agrees);
}

TEST(M107, IsOneMotorOnTwoRatiosButForTheGears) {
  const std::vector documents{m107(15, 150, 182.8, 25.6, 0.063259741),
                              m107(24, 240, 292.5, 16, 0.160478022)};
  const std::vector<Finding> findings = same_motor(documents);
  ASSERT_EQ(findings.size(), 1u);  // 25.6 * 15 = 16 * 24 = 384 rad/s, 150 / 15 = 240 / 24 = 10 Nm
  EXPECT_EQ(findings[0].rule, "same-motor-inertia");
  EXPECT_NEAR(findings[0].stated.value / findings[0].expected.value, 1.0, 0.01);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  // Oracle: (0.160478022 - 0.063259741) / (576 - 225), and 0.063259741 less 225 of it.
  EXPECT_EQ(explanation(findings[0],
                        "a rotor of 0.000277 kg m^2 and gears of 0.0009403 kg m^2 at each joint")
                .fit,
            Agreement::kFits);
}

}  // namespace
}  // namespace torquewright::actuator::lint
