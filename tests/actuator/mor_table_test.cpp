// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/mor_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "actuator/mor/mor_table_spec.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::actuator {
namespace {

/// The table's own bound between rows; `direction` chooses the row where two stand at rest.
double interpolated_Nm(const MorTable& table, double speed_rad_s, bool greatest) {
  std::size_t above = 1;
  while (above + 1 < table.rows.size() && table.rows[above].speed_rad_s < speed_rad_s) ++above;
  const MorRow& low = table.rows[above - 1];
  const MorRow& high = table.rows[above];
  const double share = (speed_rad_s - low.speed_rad_s) / (high.speed_rad_s - low.speed_rad_s);
  const double low_Nm = greatest ? low.range.greatest.torque_Nm : low.range.least.torque_Nm;
  const double high_Nm = greatest ? high.range.greatest.torque_Nm : high.range.least.torque_Nm;
  return low_Nm + share * (high_Nm - low_Nm);
}

bool has_row_at(const MorTable& table, double speed_rad_s, double tolerance_rad_s) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const MorRow& row) {
    return std::abs(row.speed_rad_s - speed_rad_s) <= tolerance_rad_s;
  });
}

// Oracle: corners of the parallelogram in closed form: 6, 10 and 14 rad/s at the joint.
TEST(MorTable, HasARowAtEveryCorner) {
  const MorTable table = mor_table(Region(round_actuator(), {}));
  for (const double corner_rad_s : {6.0, 10.0, 14.0}) {
    EXPECT_TRUE(has_row_at(table, corner_rad_s, 1e-10)) << corner_rad_s;
    EXPECT_TRUE(has_row_at(table, -corner_rad_s, 1e-10)) << corner_rad_s;
  }
  EXPECT_NEAR(table.peak_torque_Nm, 200.0, 1e-10);
  EXPECT_LE(table.interpolation_error_Nm, 1e-8);  // straight lines between corners
}

TEST(MorTable, AscendsAndHasTwoRowsAtRestOnlyWhereItJumps) {
  Actuator actuator = round_actuator();
  for (const bool jumps : {false, true}) {
    if (jumps) actuator.effects.push_back(effect("coulomb_friction", {5.0}));
    const MorTable table = mor_table(Region(actuator, {}));
    int at_rest = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      if (table.rows[i].speed_rad_s == 0.0) ++at_rest;
      if (i == 0 || table.rows[i].speed_rad_s == 0.0) continue;
      EXPECT_GT(table.rows[i].speed_rad_s, table.rows[i - 1].speed_rad_s);
    }
    EXPECT_EQ(at_rest, jumps ? 2 : 1);
    if (!jumps) continue;
    const auto first = std::find_if(table.rows.begin(), table.rows.end(),
                                    [](const MorRow& row) { return row.speed_rad_s == 0.0; });
    EXPECT_NEAR(first->range.greatest.torque_Nm, 205.0, 1e-9);        // from below: braking
    EXPECT_NEAR((first + 1)->range.greatest.torque_Nm, 195.0, 1e-9);  // from above: driving
  }
}

// Friction of 5 Nm forward only, behind a gear that bears 199 Nm: before rest -199 to 199 (of 200),
// after it -199 (of -205) to 195. One bound jumps.
TEST(MorTable, HasTwoRowsAtRestWhereOneBoundJumps) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("asymmetric_friction", {5.0, 0.0, 0.0, 0.0}));
  actuator.transmission.peak_torque_Nm = 199.0;
  const MorTable table = mor_table(Region(actuator, {}));
  const auto first = std::find_if(table.rows.begin(), table.rows.end(),
                                  [](const MorRow& row) { return row.speed_rad_s == 0.0; });
  EXPECT_EQ(first->range.greatest.torque_Nm, 199.0);
  ASSERT_EQ((first + 1)->speed_rad_s, 0.0);
  EXPECT_NEAR((first + 1)->range.greatest.torque_Nm, 195.0, 1e-9);
  EXPECT_EQ((first + 1)->range.least.torque_Nm, first->range.least.torque_Nm);
}

// At half of its voltage the search's bound of this drive scatters by 0.1 Nm close to a nose: no
// number of rows is accurate, and without an end to them there were minutes of halvings.
TEST(MorTable, EndsWhereABoundScatters) {
  const Actuator actuator = random_actuator(39, {true, true, true});
  const double half_V = 0.5 * open_circuit_voltage_V(actuator, {});
  const MorTable table = mor_table(Region(actuator, {Rating::kPeak, half_V, {}, {}}), 5e-4);
  EXPECT_LT(table.rows.size(), 3000u);
}

// Oracle: the region itself at 997 speeds that the table was not refined at; the contract's 0.1 %.
TEST(MorTable, InterpolatesWithinItsStatedAccuracy) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomActuatorOptions options;
    options.field_weakening = seed % 6 == 0;
    const Region region(random_actuator(seed, options), {});
    const MorTable table = mor_table(region);
    const double end_rad_s = region.greatest_speed_rad_s();
    EXPECT_LE(table.interpolation_error_Nm, 1e-3 * table.peak_torque_Nm) << seed;
    for (int i = 1; i < 997; ++i) {
      const double speed_rad_s = end_rad_s * (2.0 * i / 997.0 - 1.0);
      const JointRange range = region.at(speed_rad_s);
      if (range.is_empty) continue;
      EXPECT_NEAR(interpolated_Nm(table, speed_rad_s, true), range.greatest.torque_Nm,
                  1e-3 * table.peak_torque_Nm)
          << seed << " at " << speed_rad_s << " of " << end_rad_s;
      EXPECT_NEAR(interpolated_Nm(table, speed_rad_s, false), range.least.torque_Nm,
                  1e-3 * table.peak_torque_Nm)
          << seed << " at " << speed_rad_s << " of " << end_rad_s;
    }
  }
}

// Oracle: 200 Nm before 5 Nm of friction: driving keeps 195, braking has 205; at 20 rad/s the
// region is empty.
TEST(MorRows, KnowTheGreatestTorqueOfTheSpeedsAskedFor) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("coulomb_friction", {5.0}));
  const Region region(actuator, {});
  EXPECT_NEAR(mor_rows(region, {1.0, 20.0}).peak_torque_Nm, 205.0, 1e-10);   // least: -205
  EXPECT_NEAR(mor_rows(region, {-1.0, 20.0}).peak_torque_Nm, 205.0, 1e-10);  // greatest
  EXPECT_EQ(mor_rows(region, {20.0}).peak_torque_Nm, 0.0);
}

TEST(MorTableCsv, HasTheContractsColumnsAndAHeaderBlock) {
  const Actuator actuator = round_actuator();
  const MorTable table = mor_rows(Region(actuator, {}), {0.0, 20.0});
  const std::string text = mor_table_csv({&actuator, {}, Side::kJoint}, table);
  EXPECT_NE(text.find("# side: joint\n"), std::string::npos);
  EXPECT_NE(text.find("\nspeed_rad_s,torque_min_Nm,torque_max_Nm,current_min_A,current_max_A,"
                      "bus_power_at_min_W,bus_power_at_max_W,limiter_min,limiter_max\n"),
            std::string::npos);
  EXPECT_TRUE(text.ends_with("20,,,,,,,voltage,voltage\n")) << text;  // beyond the overspeed
}

TEST(MorTableJson, IsOfItsKind) {
  const Actuator actuator = round_actuator();
  const MorTable table = mor_rows(Region(actuator, {}), {5.0, 20.0});
  const auto written = mor_table_json({&actuator, {}, Side::kJoint}, table);
  EXPECT_EQ(written["kind"], "mor_table");
  EXPECT_NEAR(written["rows"][0]["torque_max_Nm"].get<double>(), 200.0, 1e-10);
  EXPECT_TRUE(written["rows"][1]["torque_max_Nm"].is_null());
  EXPECT_EQ(written["rows"][1]["limiter_max"], "voltage");
}

}  // namespace
}  // namespace torquewright::actuator
