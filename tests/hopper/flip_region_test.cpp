// SPDX-License-Identifier: Apache-2.0
// What a plan may ask of a drive. Oracle: actuator::Region, which `hopper check` judges by, on
// grids denser than those of the fit; actuator::demand_at for power; differences for derivatives.
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/check/bus_levels.hpp"
#include "actuator/check/demand.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "hopper/flip/drive_region.hpp"
#include "io/spec_error.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;

Actuator document(const char* name) {
  return actuator::read_actuator(std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/") + name)
      .actuator;
}

std::vector<double> rows_at(const DriveRegion& region, double torque_Nm, double speed_rad_s,
                            double bus_V) {
  std::vector<double> rows(region.rows());
  region.rows<double>(torque_Nm, speed_rad_s, bus_V, rows);
  return rows;
}

class LinearDrive : public testing::TestWithParam<const char*> {};

// Oracle: the closed form of a dc motor, from the document's own numbers.
TEST_P(LinearDrive, HasTheRowsOfTheDcMotor) {
  const Actuator drive = document(GetParam());
  const double k = drive.motor.torque_constant_Nm_A * drive.transmission.ratio;
  const double R = drive.motor.resistance_ohm;
  const DriveRegion region(drive, {}, {DriveLimits::kMor, 0.05, 0.08});
  ASSERT_EQ(region.rows(), 2u);
  const double most_Nm = k * drive.drive.peak_current_A;
  EXPECT_NEAR(region.greatest_torque_Nm(), 0.92 * most_Nm, 1e-9 * most_Nm);
  EXPECT_NEAR(region.greatest_speed_rad_s(), drive.drive.bus_voltage_V / k, 1e-9);
  for (const double torque_Nm : {-1.5 * most_Nm, 0.0, 40.0}) {
    for (const double speed_rad_s : {-40.0, 0.0, 7.0}) {
      for (const double bus_V : {33.0, 67.2, 87.0}) {
        const auto rows = rows_at(region, torque_Nm, speed_rad_s, bus_V);
        const double line_Nm = torque_Nm + k * k / R * speed_rad_s;
        const double room_Nm = 0.95 * k / R * bus_V;
        EXPECT_NEAR(rows[0], line_Nm - room_Nm, 1e-9 * most_Nm);
        EXPECT_NEAR(rows[1], -line_Nm - room_Nm, 1e-9 * most_Nm);
        EXPECT_NEAR(region.bus_power_W(torque_Nm, speed_rad_s, bus_V),
                    torque_Nm * speed_rad_s + R * std::pow(torque_Nm / k, 2), 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FlipRegion, LinearDrive,
                         testing::Values("d151_knee.json", "d110a_ankle.json", "cassie_knee.json"));

}  // namespace
}  // namespace torquewright::hopper
