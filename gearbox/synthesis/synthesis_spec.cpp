// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/synthesis_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearbox/search/certificate_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/strength/problem_strength.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::ordered_json;

const char* status_name(SynthesisStatus status) {
  switch (status) {
    case SynthesisStatus::kOptimal:
      return "optimal";
    case SynthesisStatus::kInfeasible:
      return "infeasible";
    case SynthesisStatus::kLimit:
      break;
  }
  return "limit";
}

ordered_json finite_or_null(double value) {
  return std::isfinite(value) && value > 0.0 ? ordered_json(value) : ordered_json();
}

ordered_json sized_json(const Problem& problem, const SizedDesign& sized) {
  ordered_json design = report_json(*find_topology(problem.topology), sized.report);
  const std::vector<std::string> layers = train_parts(problem.topology).layer_names();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    design["face_width_mm"][layers[i]] = sized.face_width_mm[i];
  }
  design["strength"] = {
      {"load_Nm", io::nearest(*problem.load_output_torque_Nm)},
      {"borne_Nm", sized.borne.joint_Nm},
      {"cycles", problem.load_cycles ? io::nearest(*problem.load_cycles) : kAssumedCycles},
      {"gear", sized.borne.gear},
      {"mesh", sized.borne.mesh},
      {"mode", sized.borne.mode == FailureMode::kBending ? "bending" : "contact"}};
  return design;
}

ordered_json conflict_json(const Problem& problem, const SynthesisResult& found) {
  ordered_json list = ordered_json::array();
  if (!found.conflict) return list;
  for (const ConflictMember& member : *found.conflict) {
    list.push_back(
        {{"constraint", member.constraint},
         {"without_it", design_json(*find_topology(problem.topology), member.without_it.value())},
         {"sentence", member.sentence}});
  }
  return list;
}

}  // namespace

std::string held_fixed_by_synthesis(const Problem& problem) {
  return problem.synthesis->layer_2_module_mm.empty() &&
                 train_parts(problem.topology).layer_count() > 1
             ? "one module for both layers, planets equally spaced and all alike, walls behind the "
               "rings as stated or of 2.25 modules"
             : "planets equally spaced and all alike, walls behind the rings as stated or of 2.25 "
               "modules";
}

std::vector<std::string> not_asked_by_synthesis() {
  return {"rims: roots are as strong as with rims too thick to matter (gearbox strength --rim).",
          "width: load lies as evenly on a wide tooth as on a narrow one (K_Fbeta 1.2, K_Hbeta "
          "1.3), up "
          "to the limits of /synthesis.",
          "carrier, bearings and shafts: masses are those of the gears."};
}

ordered_json synthesis_json(const Problem& problem, const SynthesisResult& found) {
  ordered_json result{{"kind", "gearbox_result"}, {"version", 1}};
  result["status"] = status_name(found.status);
  result["objective"] = found.best ? ordered_json(found.best->mass_kg) : ordered_json();
  result["bound"] = finite_or_null(found.bound_kg);
  result["gap"] = found.best && !result["bound"].is_null()
                      ? ordered_json(1.0 - found.bound_kg / found.best->mass_kg)
                      : ordered_json();
  result["designs"] = ordered_json::array();
  if (found.best) result["designs"].push_back(sized_json(problem, *found.best));
  result["ties"] = ordered_json::array();
  result["conflict"] = conflict_json(problem, found);
  result["would_be_feasible_with"] = ordered_json::array();
  result["search"] = {{"nodes", found.boxes},
                      {"relaxations", 0},
                      {"choices", found.choices},
                      {"choices_opened", found.opened},
                      {"excluded_by", ordered_json::object()}};
  for (const auto& [name, count] : found.excluded_by) {
    result["search"]["excluded_by"][name] = count;
  }
  result["certificate"] = certificate_json(*find_topology(problem.topology), {});
  result["held_fixed"] = held_fixed_by_synthesis(problem);
  result["not_asked"] = not_asked_by_synthesis();
  return result;
}

}  // namespace torquewright::gearbox
