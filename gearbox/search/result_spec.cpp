// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/result_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearbox/search/certificate_spec.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::ordered_json;

ordered_json whole_number(const mpz_class& value) {
  return value.fits_slong_p() ? ordered_json(value.get_si()) : ordered_json(value.get_d());
}

ordered_json constraint_json(const ConstraintReport& constraint) {
  return {{"name", constraint.name},        {"value", constraint.value},
          {"limit", constraint.limit},      {"margin", constraint.margin},
          {"unit", constraint.unit},        {"satisfied", constraint.satisfied},
          {"sentence", constraint.sentence}};
}

ordered_json gear_json(const GearReport& gear) {
  return {{"name", gear.name},
          {"teeth", gear.teeth},
          {"layer", gear.layer},
          {"internal", gear.internal},
          {"pitch_diameter_mm", gear.pitch_diameter_mm},
          {"tip_diameter_mm", gear.tip_diameter_mm},
          {"root_diameter_mm", gear.root_diameter_mm},
          {"base_diameter_mm", gear.base_diameter_mm},
          {"speed_per_input", gear.speed_per_input}};
}

ordered_json mesh_json(const MeshReport& mesh) {
  return {{"name", mesh.name},
          {"approach_ratio", mesh.approach_ratio},
          {"recess_ratio", mesh.recess_ratio},
          {"forward_loss", mesh.forward_loss},
          {"backward_loss", mesh.backward_loss},
          {"loss_share", mesh.loss_share},
          {"backlash_share", mesh.backlash_share},
          {"tangential_force_N", mesh.tangential_force_N}};
}

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

const char* status_name(DesignSearchStatus status) {
  switch (status) {
    case DesignSearchStatus::kOptimal:
      return "optimal";
    case DesignSearchStatus::kInfeasible:
      return "infeasible";
    case DesignSearchStatus::kLimit:
      break;
  }
  return "limit";
}

// |objective - bound| over the greater of the two; null where one of them is not known.
ordered_json gap(const ordered_json& objective, const ordered_json& bound) {
  if (objective.is_null() || bound.is_null()) return {};
  const double a = objective.get<double>(), b = bound.get<double>();
  return a == b ? 0.0 : std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

ordered_json conflict_json(const Topology& topology, const std::vector<ConflictMember>& members) {
  ordered_json result = ordered_json::array();
  for (const ConflictMember& member : members) {
    result.push_back({{"constraint", member.constraint},
                      {"without_it", member.without_it ? design_json(topology, *member.without_it)
                                                       : ordered_json()},
                      {"sentence", member.sentence}});
  }
  return result;
}

ordered_json looser_json(const Topology& topology, const std::vector<LooserBound>& bounds) {
  ordered_json result = ordered_json::array();
  for (const LooserBound& bound : bounds) {
    result.push_back({{"key", bound.key},
                      {"limit", bound.limit},
                      {"needed", bound.needed},
                      {"unit", bound.unit},
                      {"design", design_json(topology, bound.design)},
                      {"sentence", bound.sentence}});
  }
  return result;
}

ordered_json standing_json(const Topology& topology, const OptimalWhen& when) {
  ordered_json minima = ordered_json::array();
  for (const auto& least : when.least_minima) {
    ordered_json by_gear = ordered_json::object();
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (least[i] > 0) by_gear[std::string(topology.gears[i])] = least[i];
    }
    minima.push_back(std::move(by_gear));
  }
  return {{"min_carrier_clearance_rad",
           {{"above", when.from_zero ? ordered_json() : ordered_json(when.clearance_above_rad)},
            {"up_to", when.clearance_up_to_rad}}},
          {"least_minima", minima}};
}

/// What only designs with profile shift or a second module have.
void add_shifts(const Topology& topology, const DesignReport& report, ordered_json& result) {
  for (std::size_t i = 0; i < topology.gears.size(); ++i) {
    result["profile_shift"][std::string(topology.gears[i])] = report.gears[i].profile_shift;
  }
  const auto& second_mm = report.design.layer_2_module_mm;
  if (second_mm) result["layer_2_module_mm"] = io::nearest(*second_mm);
  result["centre_distance_mm"] = report.centre_distance_mm;
  for (const MeshReport& mesh : report.meshes) {
    result["working_angles_rad"][mesh.name] = mesh.working_angle_rad;
  }
}

}  // namespace

ordered_json report_json(const Topology& topology, const DesignReport& report) {
  ordered_json result = design_json(topology, report.design);
  if (report.design.is_shifted()) add_shifts(topology, report, result);
  result["planet_types"] = report.planet_types;
  const bool turns = report.ratio != 0;
  const auto if_turns = [&](ordered_json value) { return turns ? value : ordered_json(); };
  result["ratio"] = if_turns({{"numerator", whole_number(report.ratio.get_num())},
                              {"denominator", whole_number(report.ratio.get_den())},
                              {"value", io::nearest(report.ratio)}});
  result["objective"] = report.objective;
  result["objective_unit"] = report.objective_unit;
  result["forward_efficiency"] = if_turns(report.forward_efficiency);
  result["backward_efficiency"] = if_turns(report.backward_efficiency);
  result["self_locking"] = if_turns(report.self_locking);
  for (const MeshReport& mesh : report.meshes) {
    result["mesh_efficiencies"][mesh.name] = mesh.efficiency;
    result["contact_ratios"][mesh.name] = mesh.contact_ratio;
  }
  for (const GearReport& gear : report.gears) result["gears"].push_back(gear_json(gear));
  for (const MeshReport& mesh : report.meshes) result["meshes"].push_back(mesh_json(mesh));
  result["carrier_speed_per_input"] = report.carrier_speed_per_input;
  result["hollow_shaft_diameter_mm"] = report.hollow_shaft_diameter_mm;
  result["ring_blank_diameter_mm"] = report.ring_blank_diameter_mm;
  result["output_backlash_rad_per_mm"] = report.output_backlash_rad_per_mm;
  result["mass_kg"] = or_null(report.mass_kg);
  result["reflected_inertia_kg_m2"] = or_null(report.reflected_inertia_kg_m2);
  result["rotor_inertia_at_output_kg_m2"] = or_null(report.rotor_inertia_at_output_kg_m2);
  result["input_torque_Nm"] = or_null(report.input_torque_Nm);
  result["driving_torque_Nm"] = or_null(report.driving_torque_Nm);
  result["backdriven_torque_Nm"] = or_null(report.backdriven_torque_Nm);
  result["fixed_ring_torque_Nm"] = or_null(report.fixed_ring_torque_Nm);
  result["planet_tilting_force_N"] = or_null(report.planet_tilting_force_N);
  result["constraints"] = ordered_json::array();
  for (const ConstraintReport& constraint : report.constraints) {
    result["constraints"].push_back(constraint_json(constraint));
  }
  result["remarks"] = ordered_json::array();
  for (const Remark& remark : report.remarks) {
    result["remarks"].push_back({{"name", remark.name}, {"sentence", remark.sentence}});
  }
  return result;
}

ordered_json result_json(const Problem& problem, const DesignSearchResult& found) {
  const Topology& topology = *find_topology(problem.topology);
  ordered_json result{{"kind", "gearbox_result"}, {"version", 1}};
  result["status"] = status_name(found.status);
  result["objective"] =
      found.objectives.empty() ? ordered_json() : ordered_json(found.objectives.front());
  result["bound"] = or_null(found.bound);
  result["gap"] = gap(result["objective"], result["bound"]);
  result["designs"] = ordered_json::array();
  for (std::size_t i = 0; i < found.designs.size(); ++i) {
    result["designs"].push_back(
        report_json(topology, topology.evaluate(problem, found.designs[i])));
    result["designs"].back()["objective"] = found.objectives[i];
  }
  result["ties"] = ordered_json::array();
  for (const Design& tie : found.ties) result["ties"].push_back(design_json(topology, tie));
  result["conflict"] = conflict_json(topology, found.conflict);
  result["would_be_feasible_with"] = looser_json(topology, found.would_be_feasible_with);
  result["search"] = {{"nodes", found.search.nodes},
                      {"relaxations", found.search.relaxations},
                      {"closed_by_relaxation", found.search.refuted_by_relaxation},
                      {"points_enumerated", found.search.points_enumerated}};
  result["certificate"] = certificate_json(topology, found.claims);
  return result;
}

ordered_json evaluation_json(const Problem& problem, const DesignReport& report,
                             const Standing& standing) {
  const Topology& topology = *find_topology(problem.topology);
  ordered_json result{{"kind", "gearbox_result"}, {"version", 1}};
  // Of this design: it is the best, it is none, or it may be beaten (by how much, `bound` says).
  result["status"] = !report.feasible() ? "infeasible" : standing.rank == 1 ? "optimal" : "limit";
  result["objective"] = report.objective;
  result["bound"] = or_null(standing.best_objective);
  result["gap"] = gap(result["objective"], result["bound"]);
  result["designs"] = ordered_json::array({report_json(topology, report)});
  result["rank"] = standing.rank ? ordered_json(*standing.rank) : ordered_json();
  result["ties"] = ordered_json::array();
  for (const Design& tie : standing.ties) result["ties"].push_back(design_json(topology, tie));
  result["feasible_count"] =
      standing.feasible_count ? ordered_json(*standing.feasible_count) : ordered_json();
  result["optimal_when"] = ordered_json::array();
  for (const OptimalWhen& when : standing.optimal_when) {
    result["optimal_when"].push_back(standing_json(topology, when));
  }
  // Every design was looked at, none of it is a proof that can be handed on.
  result["conflict"] = ordered_json::array();
  result["would_be_feasible_with"] = ordered_json::array();
  result["search"] = {{"nodes", 0}, {"relaxations", 0}};
  result["certificate"] = certificate_json(topology, {});
  return result;
}

}  // namespace torquewright::gearbox
