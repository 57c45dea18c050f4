// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/library.hpp"

#include <fmt/format.h>

#include "hopper/planning/objectives/every_objective.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {

const std::vector<Objective>& every_objective() {
#define TORQUEWRIGHT_LIST(name) objectives::name,
  static const std::vector<Objective> all{TORQUEWRIGHT_EVERY_OBJECTIVE(TORQUEWRIGHT_LIST)};
#undef TORQUEWRIGHT_LIST
  return all;
}

std::vector<std::string> objective_names() {
  std::vector<std::string> names;
  for (const Objective& one : every_objective()) names.emplace_back(one.name);
  return names;
}

const Objective& objective_named(std::string_view name) {
  for (const Objective& one : every_objective()) {
    if (one.name == name) return one;
  }
  const std::vector<std::string> known = objective_names();
  const auto near = io::nearest(name, known);
  io::refuse("--objective",
             fmt::format("no objective is named \"{}\"{}; there are {}", name,
                         near ? fmt::format("; did you mean \"{}\"?", *near) : std::string(),
                         io::listed(known)));
}

std::vector<WeightedObjective> objectives_of(const PlanOptions& options) {
  if (options.objectives.empty()) return {{"effort", 1.0}};
  return options.objectives;
}

}  // namespace torquewright::hopper
