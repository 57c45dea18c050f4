// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/binding.hpp"

namespace torquewright::hopper {
std::vector<BindingConstraint> binding_constraints(const FlipProgram&, const PlannedMotion&,
                                                   const optimization::NonlinearSolution&) {
  return {};
}
}  // namespace torquewright::hopper
