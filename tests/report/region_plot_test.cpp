// SPDX-License-Identifier: Apache-2.0
// What a region's picture says in words. Oracle: a region drawn by hand, a parallelogram.
#include "src/report/actuator/region_plot.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace torquewright::report
