// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/synthesis_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearbox/any_topology.hpp"
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

/// What a conflict's design needs to be judged again.
ordered_json shifted_json(const Topology& topology, const Design& design) {
  ordered_json json = design_json(topology, design);
  for (std::size_t i = 0; i < design.profile_shift.size(); ++i) {
    json["profile_shift"][std::string(topology.gears[i])] = design.profile_shift[i];
  }
  if (design.layer_2_module_mm) json["layer_2_module_mm"] = io::nearest(*design.layer_2_module_mm);
  return json;
}

ordered_json conflict_json(const Problem& problem, const SynthesisResult& found) {
  ordered_json list = ordered_json::array();
  if (!found.conflict) return list;
  for (const ConflictMember& member : *found.conflict) {
    const std::string& own = member.topology.empty() ? problem.topology : member.topology;
    list.push_back({{"constraint", member.constraint},
                    {"without_it", shifted_json(*find_topology(own), member.without_it.value())},
                    {"sentence", member.sentence}});
    if (!member.topology.empty()) list.back()["topology"] = member.topology;
  }
  return list;
}

/// "; 12 excluded by ring_wall alone, 3 by planet_room".
std::string exclusions(const TopologyAnswer& answer) {
  std::string text;
  for (const auto& [margin, count] : answer.excluded_by) {
    text += fmt::format("{}{} excluded by {} alone", text.empty() ? "; " : ", ", count, margin);
  }
  return text;
}

ordered_json topologies_json(const SynthesisResult& found) {
  ordered_json list = ordered_json::array();
  for (const TopologyAnswer& answer : found.topologies) {
    list.push_back({{"topology", answer.topology},
                    {"status", status_name(answer.status)},
                    {"objective", answer.mass_kg ? ordered_json(*answer.mass_kg) : ordered_json()},
                    {"bound", finite_or_null(answer.bound_kg)},
                    {"choices", answer.choices},
                    {"sentence", topology_sentence(answer)}});
  }
  return list;
}

/// What is known of one topology: that nothing beats a bound, or that there is no design.
ordered_json sized_claim_json(const Problem& problem, const TopologyAnswer& answer,
                              const std::vector<std::string>& left_out) {
  ordered_json claim{{"topology", answer.topology},
                     {"quantity", objective_name(problem.objective)},
                     {"bound", finite_or_null(answer.bound_kg)},
                     {"choices", answer.choices}};
  if (answer.status == SynthesisStatus::kInfeasible) claim["left_out"] = left_out;
  return claim;
}

ordered_json sized_claims_json(const Problem& problem, const SynthesisResult& found) {
  std::vector<TopologyAnswer> answers = found.topologies;
  if (answers.empty()) {
    answers.push_back({problem.topology, found.status, {}, found.bound_kg, found.choices, {}});
  }
  ordered_json list = ordered_json::array();
  for (const TopologyAnswer& answer : answers) {
    if (answer.status != SynthesisStatus::kInfeasible && !(answer.bound_kg > 0.0)) continue;
    list.push_back(sized_claim_json(problem, answer, found.left_out));
  }
  return list;
}

}  // namespace

std::string topology_sentence(const TopologyAnswer& answer) {
  if (answer.mass_kg) {
    return fmt::format("{:.6g} g{}; none of it is lighter than {:.6g} g", 1e3 * *answer.mass_kg,
                       answer.status == SynthesisStatus::kOptimal ? ", proved" : " so far",
                       1e3 * answer.bound_kg);
  }
  if (answer.status == SynthesisStatus::kLimit) return "not settled: the search was ended";
  if (answer.choices == 0) return "none, proved: no teeth meet ratio, minima, assembly and bore";
  return fmt::format(
      "none, proved: {} choices of teeth meet ratio and assembly, and no shifts make a design of "
      "one{}",
      answer.choices, exclusions(answer));
}

std::string held_fixed_by_synthesis(const Problem& problem) {
  return problem.synthesis->layer_2_module_mm.empty() && layers_of(problem.topology).size() > 1
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
  if (found.best) result["designs"].push_back(sized_json(found.best->problem, *found.best));
  if (!found.topologies.empty()) result["topologies"] = topologies_json(found);
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
  result["certificate"] = certificate_json(topologies().front(), {});
  result["certificate"]["sized_claims"] = sized_claims_json(problem, found);
  result["held_fixed"] = held_fixed_by_synthesis(found.best ? found.best->problem : problem);
  result["not_asked"] = not_asked_by_synthesis();
  return result;
}

}  // namespace torquewright::gearbox
