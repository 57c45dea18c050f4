// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {

Problem d151() {
  Problem problem;
  problem.topology = "3k";
  problem.target_ratio = 20;
  problem.ratio_tolerance = 0;
  problem.rotor_inner_diameter_mm = Rational(397, 5);
  problem.module_mm = {Rational(3, 5)};
  problem.planet_count = {4};
  problem.min_teeth = {{"sun", 40}, {"planet_1", 40}, {"planet_2", 30}};
  problem.min_carrier_clearance_rad = Rational(13, 50);
  problem.friction_coefficient = Rational(2, 25);
  return problem;
}

Problem d151_infeasible() {
  Problem problem = d151();
  problem.min_carrier_clearance_rad = Rational(3, 10);
  return problem;
}

Problem d151_tolerant() {
  Problem problem = d151();
  problem.ratio_tolerance = Rational(1, 50);
  return problem;
}

Problem planetary_8() {
  Problem problem;
  problem.topology = "planetary";
  problem.target_ratio = 8;
  problem.ratio_tolerance = Rational(1, 100);
  problem.rotor_inner_diameter_mm = 120;
  problem.module_mm = {Rational(4, 5), Rational(1)};
  problem.planet_count = {3, 4};
  problem.min_teeth = {{"sun", 12}, {"planet", 12}};
  problem.min_carrier_clearance_rad = Rational(1, 10);
  problem.constraints = ConstraintSet::kBuildable;
  problem.objective = Objective::kMass;
  problem.face_width_mm = {{"layer_1", Rational(12)}};
  problem.density_kg_m3 = Rational(7850);
  return problem;
}

Problem most_efficient() {
  Problem problem = d151();
  problem.ratio_tolerance = Rational(1, 100);
  problem.rotor_inner_diameter_mm = 60;
  problem.min_teeth = {{"sun", 20}, {"planet_1", 20}, {"planet_2", 16}};
  problem.min_carrier_clearance_rad = Rational(1, 10);
  problem.objective = Objective::kForwardEfficiency;
  return problem;
}

Problem buildable_inertia() {
  Problem problem = most_efficient();
  problem.constraints = ConstraintSet::kBuildable;
  problem.objective = Objective::kReflectedInertia;
  problem.rotor_inner_diameter_mm = Rational(397, 5);
  problem.ring_outer_diameter_mm = Rational(86);
  problem.face_width_mm = {{"layer_1", Rational(10)}, {"layer_2", Rational(12)}};
  problem.density_kg_m3 = Rational(7850);
  problem.rotor_inertia_kg_m2 = Rational(922, 1000000);
  return problem;
}

}  // namespace torquewright::gearbox::proof_test
