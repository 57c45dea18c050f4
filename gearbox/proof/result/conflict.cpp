// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearbox/proof/result/result_parts.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// The witness satisfies all of the conflict but the constraint it was found without.
void check_witness(const Problem& problem, const std::vector<Constraint>& conflict,
                   std::size_t without, const Json* json, const std::string& place,
                   Faults& faults) {
  const auto witness = read_candidate(problem, json, place, faults);
  if (!witness) return;
  std::vector<Constraint> others = conflict;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(without));
  check_feasibility(problem, others, *witness, place, faults);
  const Alternative alternative(problem, witness->planet_count, witness->module_mm);
  if (satisfies(conflict[without], alternative, teeth_at(witness->point))) {
    faults.add(place, fmt::format("satisfies {} as well, so there is no conflict",
                                  conflict[without].name));
  }
}

}  // namespace

std::vector<Constraint> check_conflict(const Problem& problem, const Json& result, Faults& faults) {
  const std::vector<Constraint> constraints = constraints_of(problem);
  const Json& entries = elements(member(result, "conflict"));
  std::vector<Constraint> conflict;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto name = text(member(entries[i], "constraint"));
    const Constraint* constraint = name ? find_constraint(constraints, *name) : nullptr;
    if (constraint == nullptr || find_constraint(conflict, *name) != nullptr) {
      faults.add(fmt::format("/conflict/{}/constraint", i),
                 "is no constraint of this problem, or one for the second time");
      return {};
    }
    conflict.push_back(*constraint);
  }
  if (conflict.empty()) faults.add("/conflict", "is empty, though the problem is infeasible");
  for (std::size_t i = 0; i < conflict.size(); ++i) {
    const Json* witness = member(entries[i], "without_it");
    const std::string place = fmt::format("/conflict/{}/without_it", i);
    if (witness == nullptr) {
      faults.add(place, "is missing; null says that no design is known");
    } else if (!witness->is_null()) {
      check_witness(problem, conflict, i, witness, place, faults);
    }
  }
  return conflict;
}

}  // namespace torquewright::gearbox::proof
