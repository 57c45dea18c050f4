// SPDX-License-Identifier: Apache-2.0
// Friction in proportion to the load that gears carry.
#include "identification/effects/families.hpp"

namespace torquewright::identification {

void add_load_friction(DictionaryBuilder& builder) {
  const auto& parameters = actuator::find_effect("load_dependent_friction")->parameters;
  std::vector<Coefficient> both;
  std::size_t backdriving = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const actuator::Effect unit =
        effect_with("load_dependent_friction", {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0});
    // The law speaks of torque on the load; the residual of a motor-side target of torque before
    // the mesh: to first order the same.
    backdriving = builder.add(k == 0 ? "load driving" : "load backdriving",
                              [unit](const Signals& signals, std::size_t i) {
                                return unit.kind->law(unit, signals.at[i]);
                              });
    both.push_back(one(backdriving, 0.0, parameters[k].highest));
  }
  builder.variant("load_dependent_friction", both);
  builder.variant("load_dependent_friction", {both[0]}).shape = {{0.0}};
  // One coefficient for both directions of power.
  Coefficient same = both[0];
  same.terms.push_back({backdriving, 1.0});
  same.highest = 1.0;
  builder.variant("load_dependent_friction", {same}).shape = {{1.0}};
}

}  // namespace torquewright::identification
