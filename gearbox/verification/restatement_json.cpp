// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/restatement_json.hpp"

#include <nlohmann/json.hpp>

#include "gearbox/search/conflict.hpp"
#include "gearbox/search/looser_bound.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "io/documents/provenance.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

Design design_from(const Topology& topology, const Json& json) {
  Design design;
  for (const std::string_view gear : topology.gears) {
    design.teeth.push_back(json["teeth"][std::string(gear)]);
  }
  design.planet_count = json["planet_count"];
  design.module_mm = io::exact(json["module_mm"]);
  return design;
}

std::optional<Design> design_or_none(const Topology& topology, const Json& json) {
  if (json.is_null()) return std::nullopt;
  return design_from(topology, json);
}

DesignSearchStatus status_from(const Json& name) {
  if (name == "optimal") return DesignSearchStatus::kOptimal;
  return name == "limit" ? DesignSearchStatus::kLimit : DesignSearchStatus::kInfeasible;
}

/// What a result lists; absent is empty, as for the checker.
Json list(const Json& result, const char* key) { return result.value(key, Json::array()); }

}  // namespace

Json restated(const Problem& problem, const Json& result, const proof::Counts& counts) {
  const Topology& topology = *find_topology(problem.topology);
  DesignSearchResult proved;
  proved.status = status_from(result["status"]);
  for (const Json& json : list(result, "designs")) {
    proved.designs.push_back(design_from(topology, json));
    proved.objectives.push_back(topology.evaluate(problem, proved.designs.back()).objective);
  }
  for (const Json& json : list(result, "ties")) {
    proved.ties.push_back(design_from(topology, json));
  }
  if (result["bound"].is_number()) proved.bound = result["bound"].get<double>();
  for (const Json& json : list(result, "conflict")) {
    const auto without_it = design_or_none(topology, json["without_it"]);
    const std::string constraint = json["constraint"];
    proved.conflict.push_back({constraint, without_it, conflict_sentence(constraint, without_it)});
  }
  for (const Json& json : list(result, "would_be_feasible_with")) {
    proved.would_be_feasible_with.push_back(
        looser_bound(problem, json["key"], json["needed"], design_from(topology, json["design"])));
  }
  // A box that is left open was not taken from the queue.
  proved.search = {counts.nodes - counts.open_leaves, 0, counts.relaxation_leaves,
                   counts.enumerated_points};
  Json expected = result_json(problem, proved);
  // Results of before 0.2.0 do not say it.
  if (result.contains("held_fixed")) expected["held_fixed"] = held_fixed(problem);
  if (result.contains("not_asked")) expected["not_asked"] = not_asked(problem, proved.designs);
  expected.erase("certificate");
  expected["tool"] = io::tool_provenance();
  return expected;
}

}  // namespace torquewright::gearbox
