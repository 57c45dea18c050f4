// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/problem_document.hpp"

#include <optional>
#include <stdexcept>

namespace torquewright::oracles {
namespace {

using nlohmann::json;

// GMP rounds towards zero; a quotient of doubles is the nearest one, which prints as the decimal
// that the fraction stands for.
double nearest(const io::Rational& value) {
  return value.get_num().get_d() / value.get_den().get_d();
}

const char* name_of(gearbox::Objective objective) {
  switch (objective) {
    case gearbox::Objective::kPaperCost:
      return "paper_cost";
    case gearbox::Objective::kMass:
      return "mass";
    case gearbox::Objective::kHollowShaft:
      return "hollow_shaft";
    case gearbox::Objective::kForwardEfficiency:
      return "forward_efficiency";
    case gearbox::Objective::kBackwardEfficiency:
      return "backward_efficiency";
    case gearbox::Objective::kReflectedInertia:
      return "reflected_inertia";
  }
  throw std::invalid_argument("unknown objective");
}

void put(json& document, const char* pointer, const std::optional<io::Rational>& value) {
  if (value) document[json::json_pointer(pointer)] = nearest(*value);
}

}  // namespace

json problem_document(const gearbox::Problem& problem) {
  json document{{"kind", "gearbox_problem"},
                {"version", 1},
                {"name", problem.name},
                {"topology", problem.topology},
                {"target_ratio", nearest(problem.target_ratio)},
                {"ratio_tolerance", nearest(problem.ratio_tolerance)},
                {"rotor_inner_diameter_mm", nearest(problem.rotor_inner_diameter_mm)},
                {"planet_count", problem.planet_count},
                {"min_teeth", problem.min_teeth},
                {"min_carrier_clearance_rad", nearest(problem.min_carrier_clearance_rad)},
                {"constraints",
                 problem.constraints == gearbox::ConstraintSet::kPaper ? "paper" : "buildable"},
                {"objective", name_of(problem.objective)},
                {"min_contact_ratio", nearest(problem.min_contact_ratio)},
                {"min_neighbour_clearance_mm", nearest(problem.min_neighbour_clearance_mm)},
                {"sun_under_second_layer", problem.sun_under_second_layer},
                {"rotor_inertia_kg_m2", nearest(problem.rotor_inertia_kg_m2)}};
  for (const io::Rational& module : problem.module_mm) {
    document["module_mm"].push_back(nearest(module));
  }
  for (const auto& [layer, width_mm] : problem.face_width_mm) {
    document["face_width_mm"][layer] = nearest(width_mm);
  }
  put(document, "/ring_outer_diameter_mm", problem.ring_outer_diameter_mm);
  put(document, "/ring_wall_mm", problem.ring_wall_mm);
  put(document, "/cutter/hob_tip_radius", problem.cutters.hob_tip_radius);
  put(document, "/cutter/shaper_tip_radius", problem.cutters.shaper_tip_radius);
  put(document, "/cutter/hob_addendum", problem.cutters.hob_addendum);
  put(document, "/cutter/shaper_addendum", problem.cutters.shaper_addendum);
  if (problem.cutters.shaper_teeth) {
    document["cutter"]["shaper_teeth"] = *problem.cutters.shaper_teeth;
  }
  put(document, "/hollow_shaft_wall_mm", problem.hollow_shaft_wall_mm);
  put(document, "/friction_coefficient", problem.friction_coefficient);
  put(document, "/materials/density_kg_m3", problem.density_kg_m3);
  put(document, "/load/output_torque_Nm", problem.load_output_torque_Nm);
  const gearbox::Floors& floors = problem.floors;
  put(document, "/min_forward_efficiency", floors.forward_efficiency);
  put(document, "/min_backward_efficiency", floors.backward_efficiency);
  put(document, "/min_hollow_shaft_diameter_mm", floors.hollow_shaft_mm);
  put(document, "/max_axial_length_mm", floors.axial_length_mm);
  put(document, "/max_mass_kg", floors.mass_kg);
  put(document, "/max_reflected_inertia_kg_m2", floors.reflected_inertia_kg_m2);
  put(document, "/max_backlash_rad_per_mm", floors.backlash_rad_per_mm);
  return document;
}

}  // namespace torquewright::oracles
