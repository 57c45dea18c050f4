// SPDX-License-Identifier: Apache-2.0
// What a region's picture says in words. Oracle: a region drawn by hand, a parallelogram.
#include "src/report/actuator/region_plot.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace torquewright::report {
namespace {

using actuator::Limiter;

actuator::MorRow row(double speed_rad_s, double least_Nm, Limiter least, double greatest_Nm,
                     Limiter greatest) {
  actuator::MorRow made;
  made.speed_rad_s = speed_rad_s;
  made.range.least.torque_Nm = least_Nm;
  made.range.least.limiter = least;
  made.range.greatest.torque_Nm = greatest_Nm;
  made.range.greatest.limiter = greatest;
  return made;
}

TEST(RegionPlot, PrintsCornersAndNamesQuadrants) {
  actuator::MorTable table;
  table.rows = {row(-12, 320, Limiter::kVoltage, 320, Limiter::kCurrent),
                row(-8, -320, Limiter::kCurrent, 320, Limiter::kCurrent),
                row(0, -320, Limiter::kCurrent, 320, Limiter::kCurrent),
                row(8, -320, Limiter::kCurrent, 320, Limiter::kCurrent),
                row(10, -320, Limiter::kCurrent, 0, Limiter::kVoltage),
                row(12, -320, Limiter::kCurrent, -320, Limiter::kVoltage)};
  const std::string script = region_plot(PlotFormat::kSvg, "knee", {{"peak", table}});
  for (const char* corner : {"'320 Nm at 8 rad/s'", "'320 Nm at -12 rad/s'",
                             "'-320 Nm at -8 rad/s'", "'-320 Nm at 12 rad/s'"}) {
    EXPECT_NE(script.find(corner), std::string::npos) << corner;
  }
  EXPECT_EQ(script.find("Nm at 10 rad/s"), std::string::npos);
  EXPECT_EQ(script.find("Nm at 0 rad/s"), std::string::npos);
  EXPECT_NE(script.find("'driving' at graph 0.985,0.965"), std::string::npos);
  EXPECT_NE(script.find("'braking' at graph 0.985,0.035"), std::string::npos);
}

actuator::MorTable box() {
  actuator::MorTable table;
  table.rows = {row(-10, -100, Limiter::kCurrent, 100, Limiter::kCurrent),
                row(10, -100, Limiter::kCurrent, 100, Limiter::kCurrent)};
  return table;
}

// By hand: 100 Nm are there at 5 rad/s, so 130 miss 30 and 80 leave 20.
TEST(RegionPlot, ShowsTheNeedWithItsDistanceToTheBound) {
  const auto drawn = [](const PlottedNeed& need) {
    return region_plot(PlotFormat::kSvg, "knee", {{"peak", box()}}, need);
  };
  const std::string missed = drawn({5, 130, -30, 100});
  EXPECT_NE(missed.find("'needed: 130 Nm at 5 rad/s, 30 Nm missing' at 5,130"), std::string::npos)
      << missed;
  EXPECT_NE(missed.find("set arrow from 5,130 to 5,100"), std::string::npos);
  EXPECT_NE(missed.find("set yrange [-123:153]"), std::string::npos);  // a tenth of 230 around
  const std::string reached = drawn({5, 80, 20, 100});
  EXPECT_NE(reached.find("'needed: 80 Nm at 5 rad/s, margin 20 Nm'"), std::string::npos);
  const double none = -std::numeric_limits<double>::infinity();
  const std::string nowhere = drawn({50, 80, none, 0});
  EXPECT_NE(nowhere.find("'needed: 80 Nm at 50 rad/s, no torque is there'"), std::string::npos);
  EXPECT_EQ(nowhere.find("set arrow"), std::string::npos);
  EXPECT_NE(nowhere.find("set xrange [-13.6:53.6]"), std::string::npos);
}

// A limiter is told apart: a pack's power from a supply's current.
TEST(RegionPlot, NamesTheSupplyWhereThereIsNoBattery) {
  actuator::MorTable table = box();
  table.rows[1].range.greatest.limiter = Limiter::kBatteryPower;
  const std::string pack = region_plot(PlotFormat::kSvg, "knee", {{"peak", table, true}});
  EXPECT_NE(pack.find("'limited by battery_power'"), std::string::npos);
  const std::string supply = region_plot(PlotFormat::kSvg, "knee", {{"peak", table, false}});
  EXPECT_NE(supply.find("'limited by supply_current'"), std::string::npos);
  EXPECT_EQ(supply.find("battery_power"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::report
