// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/candidate.hpp"

#include <algorithm>

namespace torquewright::gearbox::proof {
namespace {

/// Teeth of the free gears; the rings have to follow from them.
std::optional<Point> read_teeth(const Problem& problem, const Json* json, const std::string& place,
                                Faults& faults) {
  const auto& gears = gear_names(problem);
  if (json == nullptr || !json->is_object() || json->size() != gears.size()) {
    faults.add(place, "does not name exactly the gears of this topology");
    return std::nullopt;
  }
  Point point{};
  const std::size_t free_gears = variable_names(problem).size();
  for (std::size_t gear = 0; gear < gears.size(); ++gear) {
    const auto teeth = whole_number(member(*json, gears[gear]));
    if (!teeth || *teeth < 1 || *teeth > 4 * kMostTeeth) {
      faults.add(place + "/" + gears[gear], "is no number of teeth");
      return std::nullopt;
    }
    if (gear < free_gears) {
      point[gear] = *teeth;
    } else if (*teeth != ring(point, static_cast<int>(gear - free_gears) + 1)) {
      faults.add(place + "/" + gears[gear], "is not coaxial with the sun and the planets");
      return std::nullopt;
    }
  }
  return point;
}

}  // namespace

std::optional<Candidate> read_candidate(const Problem& problem, const Json* json,
                                        const std::string& place, Faults& faults) {
  if (json == nullptr || !json->is_object()) {
    faults.add(place, "is no design");
    return std::nullopt;
  }
  const auto point = read_teeth(problem, member(*json, "teeth"), place + "/teeth", faults);
  if (!point) return std::nullopt;
  const auto count = whole_number(member(*json, "planet_count"));
  const auto& counts = problem.planet_count;
  if (!count || std::find(counts.begin(), counts.end(), *count) == counts.end()) {
    faults.add(place + "/planet_count", "is no choice of this problem");
    return std::nullopt;
  }
  const auto module_mm = decimal(member(*json, "module_mm"));
  const auto& modules = problem.module_mm;
  if (!module_mm || std::find(modules.begin(), modules.end(), *module_mm) == modules.end()) {
    faults.add(place + "/module_mm", "is no choice of this problem");
    return std::nullopt;
  }
  return Candidate{*point, *count, *module_mm};
}

void check_feasibility(const Problem& problem, const std::vector<Constraint>& constraints,
                       const Candidate& candidate, const std::string& place, Faults& faults) {
  const Alternative alternative(problem, candidate.planet_count, candidate.module_mm);
  for (const Constraint& constraint : constraints) {
    if (!satisfies(constraint, alternative, candidate.point)) {
      faults.add(place, "violates " + constraint.name);
    }
  }
}

}  // namespace torquewright::gearbox::proof
