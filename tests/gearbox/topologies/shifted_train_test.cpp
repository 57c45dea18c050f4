// SPDX-License-Identifier: Apache-2.0
// Designs with profile shift and two modules, through the same evaluation as all others.
#include "gearbox/topologies/shifted_train.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gearbox/constraints/shifted_gears.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/teeth/tooth_outline.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train/assembly_phase.hpp"
#include "tests/gearbox/example_problem.hpp"
#include "tests/gearbox/teeth/mesh_oracle.hpp"

namespace torquewright::gearbox {
namespace {

/// Round-off of some dozen operations; angles near 20 degrees lose a digit to inv.
constexpr double kRoundOff = 1e-11;

Problem whole_problem(const std::string& topology) {
  Problem problem = test::knee();
  problem.topology = topology;
  problem.constraints = ConstraintSet::kBuildable;
  problem.face_width_mm = {{"layer_1", Rational(10)}, {"layer_2", Rational(12)}};
  problem.density_kg_m3 = Rational(7850);
  problem.rotor_inertia_kg_m2 = Rational(1, 1000);
  if (topology == "planetary") problem.min_teeth = {{"sun", 20}, {"planet", 20}};
  return problem;
}

DesignReport evaluated(const Problem& problem, const Design& design) {
  return find_topology(problem.topology)->evaluate(problem, design);
}

void expect_same(double shifted, double plain, const std::string& what) {
  EXPECT_NEAR(shifted, plain, kRoundOff * std::max(1.0, std::abs(plain))) << what;
}

// Oracle: the evaluation without shift, of which every number but the tips is another formula.
void expect_the_plain_numbers(const Problem& problem, Design design) {
  const DesignReport plain = evaluated(problem, design);
  design = plain.design;
  design.profile_shift.assign(design.teeth.size(), 0.0);
  const DesignReport shifted = evaluated(problem, design);
  for (std::size_t i = 0; i < plain.gears.size(); ++i) {
    const GearReport& a = shifted.gears[i];
    const GearReport& b = plain.gears[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.layer, b.layer);
    expect_same(a.pitch_diameter_mm, b.pitch_diameter_mm, a.name);
    expect_same(a.tip_diameter_mm, b.tip_diameter_mm, a.name);
    expect_same(a.root_diameter_mm, b.root_diameter_mm, a.name);
    expect_same(a.base_diameter_mm, b.base_diameter_mm, a.name);
    expect_same(a.speed_per_input, b.speed_per_input, a.name);
  }
  for (std::size_t i = 0; i < plain.meshes.size(); ++i) {
    const MeshReport& a = shifted.meshes[i];
    const MeshReport& b = plain.meshes[i];
    expect_same(a.efficiency, b.efficiency, a.name);
    expect_same(a.contact_ratio, b.contact_ratio, a.name);
    expect_same(a.backlash_share, b.backlash_share, a.name);
    expect_same(a.tangential_force_N, b.tangential_force_N, a.name);
    EXPECT_NEAR(a.working_angle_rad, kReferenceAngle_rad, 1e-14) << a.name;
  }
  expect_same(shifted.forward_efficiency, plain.forward_efficiency, "forward");
  expect_same(shifted.backward_efficiency, plain.backward_efficiency, "backward");
  expect_same(shifted.hollow_shaft_diameter_mm, plain.hollow_shaft_diameter_mm, "hollow shaft");
  expect_same(shifted.ring_blank_diameter_mm, plain.ring_blank_diameter_mm, "blank");
  expect_same(shifted.mass_kg.value(), plain.mass_kg.value(), "mass");
  expect_same(shifted.reflected_inertia_kg_m2.value(), plain.reflected_inertia_kg_m2.value(),
              "inertia");
  expect_same(shifted.output_backlash_rad_per_mm, plain.output_backlash_rad_per_mm, "backlash");
  for (const ConstraintReport& constraint : plain.constraints) {
    const ConstraintReport* same = test::find(shifted, constraint.name);
    ASSERT_NE(same, nullptr) << constraint.name;
    expect_same(same->value, constraint.value, constraint.name);
    expect_same(same->limit, constraint.limit, constraint.name);
    if (std::abs(constraint.margin) > kRoundOff) {
      EXPECT_EQ(same->satisfied, constraint.satisfied) << constraint.name;
    }
  }
  EXPECT_TRUE(test::is_finite(shifted));
}

TEST(ShiftedTrain, WithoutShiftIsTheTrainItself) {
  expect_the_plain_numbers(whole_problem("3k"), {{44, 44, 32}, 4, Rational(3, 5)});
  expect_the_plain_numbers(whole_problem("3k"), {{60, 48, 44}, 4, Rational(1, 2)});
  expect_the_plain_numbers(whole_problem("planetary"), {{25, 65}, 3, Rational(3, 5)});
  expect_the_plain_numbers(whole_problem("planetary"), {{40, 36}, 4, Rational(4, 5)});
}

TEST(ShiftedTrain, WithoutShiftIsTheTrainItselfByOtherCutters) {
  for (const char* topology : {"3k", "planetary"}) {
    Problem problem = whole_problem(topology);
    problem.cutters = {Rational(1, 5), Rational(1, 10), {}, Rational(27, 20), Rational(11, 10)};
    const bool is_3k = problem.topology == "3k";
    expect_the_plain_numbers(
        problem, {is_3k ? std::vector<std::int64_t>{44, 44, 32} : std::vector<std::int64_t>{25, 65},
                  is_3k ? 4 : 3, Rational(3, 5)});
  }
}

Problem bilateral_drive(const Rational& friction) {
  Problem problem = whole_problem("3k");
  problem.target_ratio = 96;
  problem.ratio_tolerance = Rational(1, 100);
  problem.rotor_inner_diameter_mm = 90;
  problem.module_mm = {Rational(8, 10), Rational(8467, 10000)};
  problem.planet_count = {3};
  problem.min_teeth = {{"sun", 12}, {"planet_1", 12}, {"planet_2", 12}};
  problem.min_carrier_clearance_rad = 0;
  problem.friction_coefficient = friction;
  return problem;
}

Design matsuki() {
  Design design{{12, 39, 32, 90, 81}, 3, Rational(8, 10)};
  design.profile_shift = {.476, .762, .536, 2.0, 1.21};
  design.layer_2_module_mm = Rational(8467, 10000);
  return design;
}

// Reference sections 6 and 12, after Matsuki 2019: a shifted drive of two modules. The output
// mesh's working angle there is 23.5777 degrees of its own centre distance, 21.26867 mm; here it
// turns at that of the sun's layer, 21.26791 mm: cos(alpha_w) = m |Z| cos(alpha)/(2 a) makes it
// 23.5777 - 0.0047 degrees, and its contact ratio 0.0007 smaller than 1.5645, which moves the
// train's efficiencies by 2e-5 at the most.
TEST(ShiftedTrain, MeetsMatsukisDrive) {
  const DesignReport report = evaluated(bilateral_drive(Rational(1, 10)), matsuki());
  const double degree = std::numbers::pi / 180.0;
  EXPECT_NEAR(report.centre_distance_mm, 21.26791, 5e-6);
  EXPECT_NEAR(report.meshes[0].working_angle_rad, 25.6645 * degree, 5e-5 * degree);
  EXPECT_NEAR(report.meshes[1].working_angle_rad, 25.6645 * degree, 5e-5 * degree);
  EXPECT_NEAR(report.meshes[2].working_angle_rad,
              std::acos(.8467 * 49 * std::cos(20 * degree) / (2 * 21.26791)), 1e-6);
  EXPECT_NEAR(report.meshes[0].contact_ratio, 1.2324, 5e-5);
  EXPECT_NEAR(report.meshes[1].contact_ratio, 1.3163, 5e-5);
  EXPECT_NEAR(report.meshes[2].contact_ratio, 1.5645 - .0007, 1e-4);
  EXPECT_NEAR(report.meshes[0].efficiency, .98179, 5.001e-6);
  EXPECT_NEAR(report.meshes[1].efficiency, .99741, 5.001e-6);
  EXPECT_NEAR(report.meshes[2].efficiency, .99605, 5.001e-6);
  EXPECT_NEAR(report.forward_efficiency, .91975, 2.5e-5);
  EXPECT_NEAR(report.backward_efficiency, .91511, 2.5e-5);
  const DesignReport rougher = evaluated(bilateral_drive(Rational(14, 100)), matsuki());
  EXPECT_NEAR(rougher.forward_efficiency, .8905, 5.001e-5);
  EXPECT_NEAR(rougher.backward_efficiency, .8817, 5.001e-5);
  EXPECT_TRUE(report.feasible());
  EXPECT_TRUE(test::is_finite(report));
}

// The published shifts are rounded to three decimals; those that close exactly differ by less.
TEST(ShiftedTrain, ClosesPublishedShiftsToTheirDecimals) {
  Design design = matsuki();
  const auto closed = coaxial_shifts(gear_train(bilateral_drive(Rational(1, 10)), design));
  ASSERT_TRUE(closed);
  EXPECT_NEAR((*closed)[3], 2.000, 5e-4);
  EXPECT_NEAR((*closed)[4], 1.210, kCoaxialTolerance);
  design.profile_shift[3] = (*closed)[3] - 2 * kCoaxialTolerance;
  const DesignReport report = evaluated(bilateral_drive(Rational(1, 10)), design);
  EXPECT_FALSE(report.feasible());
  const ConstraintReport* coaxial = test::find(report, "coaxial.fixed_ring");
  EXPECT_FALSE(coaxial->satisfied);
  EXPECT_NEAR(coaxial->margin, -kCoaxialTolerance, 1e-12);
  EXPECT_NE(coaxial->sentence.find("needs the shift 2.000000"), std::string::npos)
      << coaxial->sentence;
}

// Oracle: by hand, torque over planets and over the circle that a ring rolls on, a R/(R - P): 418.6
// N m/3/94.375 mm; and the balances of a planet and of the carrier, which know no such circle of
// the ring. 21 + 2 43 is one tooth less than the ring has, so that the forces differ by 1.6 %.
TEST(ShiftedTrain, PushesEachMeshByItsOwnWorkingCircle) {
  Problem problem = whole_problem("planetary");
  problem.load_output_torque_Nm = 500;
  problem.module_mm = {Rational(7, 4)};
  Design design{{21, 43, 108}, 3, Rational(7, 4)};
  design.profile_shift = {.438, .0426, 0.0};
  const DesignReport report = evaluated(problem, design);
  const double sun_N = report.meshes[0].tangential_force_N;
  const double ring_N = report.meshes[1].tangential_force_N;
  EXPECT_NEAR(report.centre_distance_mm * 108 / (108 - 43), 94.375, 5e-4);
  EXPECT_NEAR(ring_N, 418.6 / 3 / 94.375e-3, 0.2);  // 0.05 of 418.6 N m
  const double centre_m = report.centre_distance_mm * 1e-3;
  EXPECT_NEAR(sun_N * centre_m * 43 / 64, ring_N * centre_m * 43 / 65, 1e-9);
  EXPECT_NEAR(3 * centre_m * (sun_N + ring_N), 500, 1e-9);
}

// SDP/SI D785 table 4-3 (the same table in Bolsover's "Profile shifted external spur gears"): m 3,
// 12 and 24 teeth, x .6 and .36, to the printed digits; here as sun and planet of a stage whose
// ring of 60 teeth closes it. The table's shifts are rounded: a = 56.4999.
TEST(ShiftedTrain, OfSdpSisPairHasItsDiameters) {
  Problem problem = whole_problem("planetary");
  problem.module_mm = {3};
  Design design{{12, 24, 60}, 3, Rational(3)};
  design.profile_shift = {.6, .36, 0.0};
  design.profile_shift = *coaxial_shifts(gear_train(problem, design));
  const DesignReport report = evaluated(problem, design);
  EXPECT_NEAR(report.centre_distance_mm, 56.5, 5e-4);
  EXPECT_NEAR(report.gears[0].tip_diameter_mm, 44.840, 5e-4);
  EXPECT_NEAR(report.gears[1].tip_diameter_mm, 79.400, 5e-4);
  EXPECT_NEAR(report.gears[0].root_diameter_mm, 32.100, 5e-4);
  EXPECT_NEAR(report.gears[1].root_diameter_mm, 66.660, 5e-4);
  EXPECT_NEAR(report.gears[0].base_diameter_mm, 33.8289, 5.001e-5);
  EXPECT_NEAR(report.gears[1].base_diameter_mm, 67.6579, 5.001e-5);
  EXPECT_NEAR(report.meshes[0].contact_ratio, 1.202, 5.001e-4);
  // The dedendum of 1.25 and the shortened tips leave the standard clearance.
  EXPECT_NEAR(test::find(report, "bottom_clearance.sun_planet")->value, .25 * 3, 1e-12);
}

ToothForm form_of(const CutGear& gear) {
  ToothForm form =
      gear.internal ? internal_gear(gear.teeth, gear.shift) : external_gear(gear.teeth, gear.shift);
  form.tip_radius = gear.tip_diameter / 2.0;
  return form;
}

// Oracle: the outlines of the teeth themselves, placed by their phases at the centre distance and
// measured by the unwound string, which knows neither involute functions nor shifts. Lengths in the
// modules of the layer.
void expect_meshes(const CutTrain& cut, const CutMesh& mesh, double planet_rad, double ring_rad) {
  const CutGear& planet = cut.gears[mesh.gear_1];
  const CutGear& ring = cut.gears[mesh.gear_2];
  const double centre = cut.centre_mm / ring.module_mm;
  const ToothForm ring_form = form_of(ring);
  ToothForm planet_form = external_gear_in_ring(planet.teeth, planet.shift, ring_form, centre);
  planet_form.tip_radius = planet.tip_diameter / 2.0;
  const Contact contact =
      measure_contact({planet_form, {centre, 0.0}, planet_rad}, {ring_form, {}, ring_rad});
  EXPECT_NEAR(contact.deepest(), 0.0, 1e-6) << mesh.name;
  EXPECT_NEAR(contact.loosest(), 0.0, 1e-6) << mesh.name;
}

TEST(ShiftedTrain, RingsThatCloseTouchOnBothFlanks) {
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> shift(-0.1, 0.6);
  std::uniform_real_distribution<double> module_mm(0.56, 0.64);
  Problem problem = bilateral_drive(Rational(1, 10));
  int closed_trains = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Design design{{36, 34, 26, 104, 96}, 4, Rational(3, 5)};
    design.profile_shift = {shift(generator), shift(generator), shift(generator), 0.0, 0.0};
    design.layer_2_module_mm = io::exact(module_mm(generator));
    const auto closed = coaxial_shifts(gear_train(problem, design));
    if (!closed || std::abs((*closed)[4]) > 2.0) continue;
    design.profile_shift = *closed;
    const CutTrain cut = *cut_train(gear_train(problem, design));
    const auto paths = contact_paths(cut);  // A tooth touches in every phase where it exceeds 1.
    if (contact_ratio(paths[1]) < 1.0 || contact_ratio(paths[2]) < 1.0) continue;
    const AssemblyPhase phase = assemble_3k({36, 34, 26, 104, 96}, 4);
    const PlanetPhase& first = phase.planets.front();
    expect_meshes(cut, cut.meshes[1], first.planet_1_rad, phase.fixed_ring_rad);
    expect_meshes(cut, cut.meshes[2], first.planet_2_rad, phase.output_ring_rad);
    ++closed_trains;
  }
  EXPECT_GE(closed_trains, 10);
}

// Oracle: the area of the drawn outline. The reference calls a disc good to 1 or 2 %, 2.4 % for 20
// teeth without shift: spaces go deeper than teeth rise. With shift that disc is the middle circle
// of the reference profile, z + 2 x; the pitch circle would be off by 4 x/z, 17 % in one case here.
double area_of(const ToothForm& form) {
  const std::vector<Point> points = sample(pitch_curves(form), 1e-5);
  double sectors = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sectors += points[i - 1].x * points[i].y - points[i - 1].y * points[i].x;
  }
  return 0.5 * sectors * static_cast<double>(form.teeth);
}

TEST(ShiftedTrain, WeighsWhatItsOutlineEncloses) {
  for (const double x : {-0.3, 0.0, 0.5, 1.0}) {
    for (const std::int64_t teeth : {24, 44, 80}) {
      const double disc = std::numbers::pi / 4 * square(static_cast<double>(teeth) + 2 * x);
      const double share = area_of(external_gear(teeth, x)) / disc;
      EXPECT_GT(share, 0.97) << teeth << " " << x;
      EXPECT_LT(share, 1.0) << teeth << " " << x;
    }
  }
  const Problem problem = whole_problem("planetary");
  Design design{{40, 36, 112}, 4, Rational(3, 5)};
  design.profile_shift = {.2, .5, 0.0};
  design.profile_shift = *coaxial_shifts(gear_train(problem, design));
  const double mass_kg = evaluated(problem, design).mass_kg.value();
  const auto disc_kg = [](double diameter) {
    return 7850 * std::numbers::pi / 4 * 0.010 * square(0.6e-3 * diameter);
  };
  const double ring = 112 + 2 * design.profile_shift[2];  // rim: 2.5 and two walls of 2.25 modules
  const double expected_kg =
      disc_kg(40.4) - disc_kg(40.4 - 7) + 4 * disc_kg(37) + disc_kg(ring + 7) - disc_kg(ring);
  EXPECT_NEAR(mass_kg, expected_kg, 1e-12);
}

// A sun far undercut without shift is not with it; a tip that reaches into a base circle is seen.
TEST(ShiftedTrain, MeetsAndMissesWhatShiftDecides) {
  const Problem problem = whole_problem("planetary");
  Design design{{12, 24, 60}, 3, Rational(3, 5)};
  const auto report_with = [&](double sun, double planet) {
    design.profile_shift = {sun, planet, 0.0};
    design.profile_shift = *coaxial_shifts(gear_train(problem, design));
    return evaluated(problem, design);
  };
  EXPECT_FALSE(
      test::find(report_with(.29, .1), "undercut.sun")->satisfied);  // 1 - 12/17.097 = .2981
  EXPECT_TRUE(test::find(report_with(.299, .1), "undercut.sun")->satisfied);
  // s_a by bisection of inv in another language: .0296316 and -.0726722 modules.
  EXPECT_NEAR(test::find(report_with(1.2, .1), "tip_thickness.sun")->value, .6 * .0296316, 1e-7);
  EXPECT_NEAR(test::find(report_with(1.4, .1), "tip_thickness.sun")->value, -.6 * .0726722, 1e-7);
  EXPECT_FALSE(test::find(report_with(1.4, .1), "tip_thickness.sun")->satisfied);
  EXPECT_TRUE(test::find(report_with(.6, .36), "root_form.hob.sun_planet")->satisfied);
  EXPECT_FALSE(test::find(report_with(-.4, .9), "root_form.hob.sun_planet")->satisfied);
  design.profile_shift = {.6, .36, 0.0};  // a ring that is far from closing leaves no clearance
  EXPECT_FALSE(test::find(evaluated(problem, design), "coaxial.ring")->satisfied);
  EXPECT_LT(test::find(evaluated(problem, design), "bottom_clearance.planet_ring")->value, 0.0);
}

// A second layer that cannot close leaves the first as it is. Oracle: the closing shift of the
// layer alone, whose output ring is one that closes.
TEST(ShiftedTrain, ClosesTheFirstLayerWhereTheSecondCannot) {
  const Problem problem = bilateral_drive(Rational(1, 10));
  Design design{{36, 34, 26, 104, 96}, 4, Rational(3, 5)};
  design.profile_shift = {.2, .3, .1, 0.0, 0.0};
  const double closing = (*coaxial_shifts(gear_train(problem, design)))[3];
  EXPECT_NE(closing, 0.0);
  design.teeth[4] = 140;  // Its base circles are too far apart for this centre distance.
  design.profile_shift = *coaxial_shifts(gear_train(problem, design));
  EXPECT_EQ(design.profile_shift[3], closing);
  EXPECT_EQ(design.profile_shift[4], 0.0);
  const DesignReport report = evaluated(problem, design);
  EXPECT_TRUE(test::find(report, "coaxial.fixed_ring")->satisfied);
  EXPECT_FALSE(test::find(report, "coaxial.output_ring")->satisfied);
}

TEST(ShiftedTrain, IsRefusedWithoutAWorkingAngle) {
  const Problem problem = whole_problem("planetary");
  Design design{{12, 24, 60}, 3, Rational(3, 5)};
  design.profile_shift = {-.5, -.5, 0.0};
  EXPECT_NE(shift_objection(problem, design).find("no working angle"), std::string::npos);
  EXPECT_THROW(static_cast<void>(evaluated(problem, design)), std::invalid_argument);
  design.profile_shift = {.1, .1, 0.0};
  EXPECT_EQ(shift_objection(problem, design), "");
}

}  // namespace
}  // namespace torquewright::gearbox
