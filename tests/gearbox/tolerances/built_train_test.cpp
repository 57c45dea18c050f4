// SPDX-License-Identifier: Apache-2.0
// Gears as made, one mesh at a time. Oracles: tooth thicknesses on the working circles, closed
// forms to first order, the evaluation of nominal gears, the published grades of ISO 286-1.
#include "gearbox/tolerances/built_train.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/gearbox/tolerances/tolerated_trains.hpp"

namespace torquewright::gearbox {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;
constexpr double kAlpha_rad = kPi / 9.0;

double inv(double angle_rad) { return std::tan(angle_rad) - angle_rad; }

double cosine_of_working_angle(const CutTrain& cut, const CutMesh& mesh, double centre_mm) {
  const CutGear &first = cut.gears[mesh.gear_1], &second = cut.gears[mesh.gear_2];
  const double teeth =
      second.internal ? second.count() - first.count() : second.count() + first.count();
  return first.module_mm * teeth * std::cos(kAlpha_rad) / (2.0 * centre_mm);
}

/// Arc of a tooth (of a ring: of a space) on the circle of a working angle.
double arc_mm(const CutGear& gear, double working_rad) {
  const double d_mm = gear.module_mm * gear.count();
  const double s_mm = gear.module_mm * (0.5 * kPi + 2.0 * gear.shift * std::tan(kAlpha_rad));
  const double working_mm = d_mm * std::cos(kAlpha_rad) / std::cos(working_rad);
  return working_mm * (s_mm / d_mm + inv(kAlpha_rad) - inv(working_rad));
}

/// What tooth and tooth leave of a pitch, tooth and space of each other, on the working circle, and
/// from there to the line of action.
double backlash_by_arcs_mm(const CutTrain& cut, const CutMesh& mesh, double centre_mm) {
  const CutGear &first = cut.gears[mesh.gear_1], &second = cut.gears[mesh.gear_2];
  const double working_rad = std::acos(cosine_of_working_angle(cut, mesh, centre_mm));
  const double pitch_mm = kPi * first.module_mm * std::cos(kAlpha_rad) / std::cos(working_rad);
  const double first_mm = arc_mm(first, working_rad), second_mm = arc_mm(second, working_rad);
  const double left_mm = second.internal ? second_mm - first_mm : pitch_mm - first_mm - second_mm;
  return left_mm * std::cos(working_rad);
}

TEST(BuiltMesh, HasTheBacklashThatTheArcsLeave) {
  for (const ToleratedTrain& train : {tolerated_knee(), tolerated_drive(), tolerated_stage()}) {
    for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
      for (const double off_mm : {-0.05, 0.0, 0.013, 0.2}) {
        const double built_mm =
            built_mesh(train, mesh, but(train, "centre_distance", off_mm)).backlash_mm;
        EXPECT_NEAR(
            built_mm,
            backlash_by_arcs_mm(train.cut, train.cut.meshes[mesh], train.cut.centre_mm + off_mm),
            1e-12)
            << train.cut.meshes[mesh].name << " " << off_mm;
      }
    }
  }
}

// Closed form: 2 delta_a tan(alpha_w) on the working circles, opened outside and closed in a ring;
// the rest is of second order, 1/2 |d2j/da2| delta_a^2 with d2j/da2 = 2 cos(alpha_w)/(a
// tan(alpha_w)).
TEST(BuiltMesh, OpensWithTheCentreDistance) {
  constexpr double kOff_mm = 0.01;
  for (const ToleratedTrain& train : {tolerated_knee(), tolerated_drive()}) {
    for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
      const CutMesh& gears = train.cut.meshes[mesh];
      const double cosine = cosine_of_working_angle(train.cut, gears, train.cut.centre_mm);
      const double working_rad = std::acos(cosine);
      const double sign = train.cut.gears[gears.gear_2].internal ? -1.0 : 1.0;
      const double before_mm = built_mesh(train, mesh, nominal(train)).backlash_mm;
      const double after_mm =
          built_mesh(train, mesh, but(train, "centre_distance", kOff_mm)).backlash_mm;
      const double second_order_mm =
          1.01 * cosine / (train.cut.centre_mm * std::tan(working_rad)) * kOff_mm * kOff_mm;
      EXPECT_NEAR((after_mm - before_mm) / cosine, sign * 2.0 * kOff_mm * std::tan(working_rad),
                  second_order_mm / cosine)
          << gears.name;
      EXPECT_NEAR(backlash_per_centre_distance(train, mesh, 0.0),
                  sign * 2.0 * std::sin(working_rad), 1e-12);
    }
  }
}

// Thinner teeth leave what they lack, along the line of action its cosine; a shift of dx modules
// makes a tooth 2 dx tan(alpha) modules thicker.
TEST(BuiltMesh, OpensWithThinnerTeeth) {
  const ToleratedTrain train = tolerated_knee();
  for (const char* gear : {"planet_1", "fixed_ring"}) {
    const std::string name(gear);
    EXPECT_NEAR(built_mesh(train, 1, but(train, "tooth_thickness." + name, -0.03)).backlash_mm,
                0.03 * std::cos(kAlpha_rad), 1e-12);
  }
  EXPECT_NEAR(built_mesh(train, 0, but(train, "profile_shift.sun", -0.02)).backlash_mm,
              2.0 * 0.02 * 0.6 * std::sin(kAlpha_rad), 1e-12);
  EXPECT_NEAR(built_mesh(train, 1, but(train, "profile_shift.fixed_ring", 0.02)).backlash_mm,
              2.0 * 0.02 * 0.6 * std::sin(kAlpha_rad), 1e-12);
  EXPECT_NEAR(built_mesh(train, 0, but(train, "tooth_thickness.planet_2", -0.03)).backlash_mm, 0.0,
              1e-12);
}

TEST(BuiltMesh, HasTheContactRatioOfTheEvaluation) {
  const ToleratedTrain train = tolerated_knee();
  const DesignReport report = find_topology("3k")->evaluate(knee(), kKneeDesign);
  for (std::size_t mesh = 0; mesh < 3; ++mesh) {
    const BuiltMesh built = built_mesh(train, mesh, nominal(train));
    EXPECT_NEAR(built.contact_ratio, report.meshes[mesh].contact_ratio, 1e-12);
    EXPECT_NEAR(built.tip_clearance_mm(), 0.25 * 0.6, 1e-12);  // 1.25 - 1 modules.
  }
}

// A tip that is less by t on the diameter stands t/2 farther from the root, and so does a pin.
TEST(BuiltMesh, ClearsTipsByWhatTheyLack) {
  const ToleratedTrain train = tolerated_knee();
  const BuiltMesh shorter = built_mesh(train, 0, but(train, "tip_diameter.planet_1", -0.04));
  EXPECT_NEAR(shorter.tip_1_clearance_mm, 0.15, 1e-12);
  EXPECT_NEAR(shorter.tip_2_clearance_mm, 0.17, 1e-12);
  EXPECT_NEAR(built_mesh(train, 1, but(train, "centre_distance", 0.03)).tip_clearance_mm(), 0.12,
              1e-12);
  EXPECT_NEAR(built_mesh(train, 1, but(train, "tip_diameter.fixed_ring", 0.04)).tip_2_clearance_mm,
              0.17, 1e-12);
}

// Oracle: the table of ISO 286-1, made at the geometric mean of each range: IT7, IT8, IT9.
TEST(PartLimits, AreOfTheUnitOfIso286) {
  struct Range {
    double from_mm, to_mm, it7_um, it8_um, it9_um;
  };
  for (const Range& range :
       {Range{10, 18, 18, 27, 43}, {18, 30, 21, 33, 52}, {50, 80, 30, 46, 74}}) {
    const double unit_um = 1e3 * tolerance_unit_mm(std::sqrt(range.from_mm * range.to_mm));
    EXPECT_NEAR(16.0 * unit_um, range.it7_um, 0.7);
    EXPECT_NEAR(25.0 * unit_um, range.it8_um, 0.7);
    EXPECT_NEAR(40.0 * unit_um, range.it9_um, 0.7);
  }
}

// Both gears at the thicker of their limits, pins in place: the recommended backlash.
TEST(PartLimits, LeaveTheRecommendedBacklash) {
  const ToleratedTrain train = tolerated_knee();
  std::vector<double> thickest = nominal(train);
  for (std::size_t i = 0; i < thickest.size(); ++i) {
    if (train.limits[i].dimension == Dimension::kToothThickness) {
      thickest[i] = train.limits[i].greatest;
    }
  }
  for (std::size_t mesh = 0; mesh < 3; ++mesh) {
    EXPECT_NEAR(built_mesh(train, mesh, thickest).backlash_mm,
                2.0 / 3.0 * (0.06 + 0.0005 * 26.4 + 0.03 * 0.6), 1e-12);
  }
}

TEST(ToleratedTrain, RefusesPinsThatLeaveNoWorkingAngle) {
  ToleratedTrain train = tolerated_knee();
  train.limits[0].least = -2.0;
  try {
    (void)tolerated(knee(), kKneeDesign, train.limits);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "at a centre distance of 24.4 mm sun_planet_1 has no working angle: the base "
                 "circles of its gears do not allow it");
  }
}

}  // namespace
}  // namespace torquewright::gearbox
