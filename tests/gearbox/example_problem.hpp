// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "gearbox/constraints/design_report.hpp"

namespace torquewright::gearbox::test {

/// The knee of seed 001: 20:1, rotor bore 79.4 mm, module 0.6.
inline Problem knee() {
  Problem problem;
  problem.name = "knee";
  problem.topology = "3k";
  problem.target_ratio = 20;
  problem.rotor_inner_diameter_mm = Rational(397, 5);
  problem.module_mm = {Rational(3, 5)};
  problem.planet_count = {4};
  problem.min_teeth = {{"sun", 40}, {"planet_1", 40}, {"planet_2", 30}};
  problem.min_carrier_clearance_rad = Rational(13, 50);
  problem.friction_coefficient = Rational(2, 25);
  problem.load_output_torque_Nm = Rational(320);
  return problem;
}

inline const ConstraintReport* find(const DesignReport& report, const std::string& name) {
  for (const ConstraintReport& constraint : report.constraints) {
    if (constraint.name == name) return &constraint;
  }
  return nullptr;
}

inline const Remark* find_remark(const DesignReport& report, const std::string& name) {
  for (const Remark& remark : report.remarks) {
    if (remark.name == name) return &remark;
  }
  return nullptr;
}

/// Every number of a report is finite, no sentence holds a "nan" or "inf".
inline bool is_finite(const DesignReport& report) {
  bool finite = true;
  const auto see = [&finite](double value) { finite = finite && std::isfinite(value); };
  const auto read = [&finite](const std::string& text) {
    finite = finite && !text.empty() && text.find("nan") == std::string::npos &&
             text.find("inf") == std::string::npos;
  };
  for (const GearReport& gear : report.gears) {
    see(gear.pitch_diameter_mm + gear.tip_diameter_mm + gear.root_diameter_mm +
        gear.base_diameter_mm + gear.speed_per_input);
  }
  for (const MeshReport& mesh : report.meshes) {
    see(mesh.efficiency + mesh.contact_ratio + mesh.approach_ratio + mesh.recess_ratio);
    see(mesh.loss_share + mesh.backlash_share + mesh.tangential_force_N);
  }
  for (const ConstraintReport& constraint : report.constraints) {
    see(constraint.value + constraint.limit + constraint.margin);
    read(constraint.sentence);
    finite =
        finite && (constraint.satisfied == (constraint.margin >= 0.0) || constraint.margin == 0);
  }
  for (const Remark& remark : report.remarks) read(remark.sentence);
  see(report.ratio.get_d() + report.carrier_speed_per_input + report.objective);
  see(report.forward_efficiency + report.backward_efficiency + report.hollow_shaft_diameter_mm);
  see(report.ring_blank_diameter_mm + report.output_backlash_rad_per_mm);
  see(report.mass_kg.value_or(0) + report.reflected_inertia_kg_m2.value_or(0));
  see(report.input_torque_Nm.value_or(0) + report.fixed_ring_torque_Nm.value_or(0) +
      report.planet_tilting_force_N.value_or(0));
  return finite;
}

}  // namespace torquewright::gearbox::test
