// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/claims/candidate.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torquewright::gearbox::proof {
namespace {

constexpr std::int64_t kMostRingTeeth = 4 * kMostTeeth;

/// Teeth of the free gears; the rings have to follow from them.
std::optional<Teeth> read_teeth(const Problem& problem, const Json* json, const std::string& place,
                                Faults& faults) {
  const auto& gears = train_of(problem).gears();
  if (json == nullptr || !json->is_object() || json->size() != gears.size()) {
    faults.add(place, "does not name exactly the gears of this topology");
    return std::nullopt;
  }
  std::vector<std::int64_t> counts;
  for (const std::string& gear : gears) {
    const auto count = whole_number(member(*json, gear));
    if (!count || *count < 1 || *count > kMostRingTeeth) {
      faults.add(place + "/" + gear, "is no number of teeth");
      return std::nullopt;
    }
    counts.push_back(*count);
  }
  const std::size_t free_gears = train_of(problem).free_gears.size();
  const Teeth teeth{counts[0], counts[1], free_gears == 3 ? counts[2] : counts[1]};
  for (std::size_t gear = free_gears; gear < gears.size(); ++gear) {
    if (counts[gear] != ring(teeth, static_cast<int>(gear - free_gears) + 1)) {
      faults.add(place + "/" + gears[gear], "is not coaxial with the sun and the planets");
      return std::nullopt;
    }
  }
  return teeth;
}

}  // namespace

std::optional<Candidate> read_candidate(const Problem& problem, const Json* json,
                                        const std::string& place, Faults& faults) {
  if (json == nullptr || !json->is_object()) {
    faults.add(place, "is no design");
    return std::nullopt;
  }
  const auto teeth = read_teeth(problem, member(*json, "teeth"), place + "/teeth", faults);
  if (!teeth) return std::nullopt;
  const std::int64_t difference = teeth->planet_1 - teeth->planet_2;
  if (train_of(problem).is_stepped() && difference < 1) {
    faults.add(place + "/teeth", "is no design of the domain: planet_2 is not less than planet_1");
    return std::nullopt;
  }
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
  return Candidate{Point{teeth->sun, teeth->planet_1, difference}, *count, *module_mm};
}

void check_feasibility(const Problem& problem, const std::vector<Constraint>& constraints,
                       const Candidate& candidate, const std::string& place, Faults& faults) {
  const Alternative alternative(problem, candidate.planet_count, candidate.module_mm);
  for (const Constraint& constraint : constraints) {
    if (!satisfies(constraint, alternative, teeth_at(candidate.point))) {
      faults.add(place, "violates " + constraint.name);
    }
  }
}

}  // namespace torquewright::gearbox::proof
