// SPDX-License-Identifier: Apache-2.0
#include "actuator/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "actuator/mor/clip_table.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"

extern "C" double clip_parallelogram_in_c(double stall, double no_load, double greatest,
                                          double speed, double torque);
extern "C" void clip_table_in_c(const torquewright_table* table, const double* speed,
                                const double* torque, double* clipped, size_t count);

namespace torquewright::actuator {
namespace {

// A few roundings of the torques' magnitude.
constexpr double kClipRounding = 1e-12;

// Oracle: RaiSim 2's documentation (docs/sections/Actuators.rst): R 0.2 ohm, Kt 0.1 Nm/A, Kv 10
// rad/s/V, 24 V, peak 1.5 Nm: no-load speed 240 rad/s; at 238 rad/s 0.1 Nm are left.
constexpr Parallelogram kRaisimMotor{12.0, 240.0, 1.5};

TEST(ClipToParallelogram, IsRaisimsDocumentedMotor) {
  EXPECT_NEAR(clip(kRaisimMotor, 0.0, 99.0), 1.5, kClipRounding);
  EXPECT_NEAR(clip(kRaisimMotor, 238.0, 99.0), 0.1, kClipRounding);
  EXPECT_NEAR(clip(kRaisimMotor, 240.0, 99.0), 0.0, kClipRounding);
  EXPECT_NEAR(clip(kRaisimMotor, -238.0, -99.0), -0.1, kClipRounding);
  EXPECT_EQ(clip(kRaisimMotor, 100.0, 0.7), 0.7);
}

TEST(ClipToParallelogram, BrakesFullyInTheOtherQuadrants) {
  EXPECT_EQ(clip(kRaisimMotor, 238.0, -99.0), -1.5);
  EXPECT_EQ(clip(kRaisimMotor, -238.0, 99.0), 1.5);
  // Between no-load and overspeed (270 rad/s) it cannot help braking: 12 (1 - 250/240) = -0.5.
  EXPECT_NEAR(clip(kRaisimMotor, 250.0, 0.0), -0.5, kClipRounding);
  EXPECT_NEAR(clip(kRaisimMotor, -250.0, 0.0), 0.5, kClipRounding);
}

TEST(ClipToParallelogram, LeavesTheGreatestTorqueAgainstTheMotionPastOverspeed) {
  for (const double torque_Nm : {-99.0, 0.0, 99.0}) {
    EXPECT_EQ(clip(kRaisimMotor, 271.0, torque_Nm), -1.5);
    EXPECT_EQ(clip(kRaisimMotor, -1e9, torque_Nm), 1.5);
  }
}

TEST(ClipToParallelogram, IsTheSameInCAndInBatches) {
  std::mt19937 dice(1);
  std::uniform_real_distribution<double> speed(-400.0, 400.0);
  std::uniform_real_distribution<double> torque(-20.0, 20.0);
  std::vector<double> speeds(1000);
  std::vector<double> torques(1000);
  for (double& value : speeds) value = speed(dice);
  for (double& value : torques) value = torque(dice);
  std::vector<double> in_place = torques;
  clip(kRaisimMotor, speeds.data(), in_place.data(), in_place.data(), in_place.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double expected_Nm = clip(kRaisimMotor, speeds[i], torques[i]);
    EXPECT_EQ(in_place[i], expected_Nm);
    EXPECT_EQ(clip_parallelogram_in_c(12.0, 240.0, 1.5, speeds[i], torques[i]), expected_Nm);
  }
}

TEST(Clip, HandsOnWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ClipTable table(Example(lossy_knee()).table);
  EXPECT_TRUE(std::isnan(clip(kRaisimMotor, nan, 1.0)));
  EXPECT_TRUE(std::isnan(clip(kRaisimMotor, 1.0, nan)));
  EXPECT_TRUE(std::isnan(clip(table.view(), nan, 1.0)));
  EXPECT_TRUE(std::isnan(clip(table.view(), 1.0, nan)));
}

// Oracle: the region itself, at speeds that are not the table's rows.
void expect_region(const Example& example) {
  const ClipTable table(example.table);
  const TableView view = table.view();
  const double end_rad_s = example.region.greatest_speed_rad_s();
  // What the table promises of itself, found at a few probes; between them a little more.
  const double tolerance_Nm =
      1.2 * example.table.interpolation_error_Nm + 1e-9 * example.table.peak_torque_Nm;
  std::mt19937 dice(2);
  std::uniform_real_distribution<double> speed(-end_rad_s, end_rad_s);
  for (int i = 0; i < 2000; ++i) {
    const double speed_rad_s = i == 0 ? 0.0 : speed(dice);
    const JointRange range = example.region.at(speed_rad_s);
    ASSERT_FALSE(range.is_empty);
    EXPECT_NEAR(clip(view, speed_rad_s, 1e9), range.greatest.torque_Nm, tolerance_Nm)
        << speed_rad_s;
    EXPECT_NEAR(clip(view, speed_rad_s, -1e9), range.least.torque_Nm, tolerance_Nm) << speed_rad_s;
  }
}

TEST(ClipToTable, IsTheRegionOfALosslessActuator) { expect_region(Example(knee())); }

TEST(ClipToTable, IsTheRegionWithFrictionAndSaturation) { expect_region(Example(lossy_knee())); }

TEST(ClipToTable, TakesTheUnionAtRestAndEachSideBesideIt) {
  const Example example(lossy_knee());
  const ClipTable table(example.table);
  const TableView view = table.view();
  const double forward_Nm = example.region.at(0.0, 1.0).greatest.torque_Nm;
  const double backward_Nm = example.region.at(0.0, -1.0).greatest.torque_Nm;
  ASSERT_GT(backward_Nm, forward_Nm + 50.0);  // or the jump tests nothing
  const double tolerance_Nm = 1e-6 * backward_Nm;
  EXPECT_NEAR(clip(view, 0.0, 1e9), backward_Nm, tolerance_Nm);
  EXPECT_NEAR(clip(view, -0.0, 1e9), backward_Nm, tolerance_Nm);
  EXPECT_NEAR(clip(view, 1e-9, 1e9), forward_Nm, tolerance_Nm);
  EXPECT_NEAR(clip(view, -1e-9, 1e9), backward_Nm, tolerance_Nm);
}

TEST(ClipToTable, FindsTheSameRowByIndexByBisectionAndInC) {
  const Example example(lossy_knee());
  const ClipTable table(example.table);
  const TableView indexed = table.view();
  TableView searched = indexed;
  searched.first_row = nullptr;
  std::vector<double> speeds_rad_s =
      clip_points(example.table).speeds_rad_s;  // the rows themselves, too
  const double end_rad_s = 1.5 * example.region.greatest_speed_rad_s();
  for (int i = -5000; i <= 5000; ++i) speeds_rad_s.push_back(end_rad_s * i / 5000);
  const std::vector<double> torques_Nm(speeds_rad_s.size(), 1e9);
  std::vector<double> in_c(speeds_rad_s.size());
  std::vector<double> in_batch(speeds_rad_s.size());
  clip_table_in_c(&indexed, speeds_rad_s.data(), torques_Nm.data(), in_c.data(), in_c.size());
  clip(indexed, speeds_rad_s.data(), torques_Nm.data(), in_batch.data(), in_batch.size());
  for (std::size_t i = 0; i < speeds_rad_s.size(); ++i) {
    const double expected_Nm = clip(searched, speeds_rad_s[i], 1e9);
    EXPECT_EQ(clip(indexed, speeds_rad_s[i], 1e9), expected_Nm) << speeds_rad_s[i];
    EXPECT_EQ(in_c[i], expected_Nm);
    EXPECT_EQ(in_batch[i], expected_Nm);
  }
}

TEST(ClipToTable, HoldsItsEndsAndNeedsTwoRows) {
  const Example example(knee());
  const ClipTable table(example.table);
  EXPECT_NEAR(clip(table.view(), 1e6, 1e9), -320.0, 1e-6);
  EXPECT_NEAR(clip(table.view(), -1e6, 0.0), 320.0, 1e-6);
  EXPECT_THROW(ClipTable(mor_rows(example.region, {1.0})), std::invalid_argument);
}

// A region without regeneration ends at the no-load speed; the rows beyond it are empty.
TEST(ClipToTable, LeavesOutRowsWhereTheRegionIsEmpty) {
  Actuator actuator = knee();
  actuator.drive.regeneration = false;
  const Example example(actuator);
  const ClipTable table(example.table);
  for (int i = -1000; i <= 1000; ++i) {
    EXPECT_TRUE(std::isfinite(clip(table.view(), 0.02 * i, 1e9))) << i;
  }
}

}  // namespace
}  // namespace torquewright::actuator
