// SPDX-License-Identifier: Apache-2.0
// Friction that falls with speed near rest.
#include "identification/effects/families.hpp"

namespace torquewright::identification {

void add_stribeck(DictionaryBuilder& builder) {
  // The part beyond Coulomb, (s - c) exp(-(w/v)^2): the law at c = 0.
  const double fast_rad_s = builder.extent().speed_rad_s;
  const std::vector<double> grid = geometric(0.01 * fast_rad_s, 0.5 * fast_rad_s, 8);
  const double c = builder.stated("coulomb_friction");
  std::vector<std::size_t> columns;
  for (const double speed : grid) {
    columns.push_back(
        builder.add_drag("stribeck", effect_with("stribeck_friction", {0.0, 1.0, speed})));
  }
  const auto add = [&](const std::vector<std::size_t>& places) {
    std::vector<Coefficient> coefficients = {beyond(builder.coulomb, c)};
    for (const std::size_t k : places) coefficients.push_back(one(columns[k], 0.0, kInfinity));
    Variant& added = builder.variant("stribeck_friction", std::move(coefficients));
    added.shape = {{}};
    for (const std::size_t k : places) added.shape.push_back({grid[k]});
    added.stated.assign(places.size() + 1, 0.0);
    added.stated.front() = c;
    added.replaces = {"coulomb_friction"};
  };
  for (std::size_t k = 0; k + 1 < grid.size(); ++k) add({k, k + 1});
  for (std::size_t k = 0; k < grid.size(); ++k) add({k});
}

}  // namespace torquewright::identification
