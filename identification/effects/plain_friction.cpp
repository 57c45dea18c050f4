// SPDX-License-Identifier: Apache-2.0
// Friction that follows speed and its sign alone.
#include "identification/effects/families.hpp"

namespace torquewright::identification {
namespace {

/// Levels, then slopes, each for the two directions.
std::vector<Coefficient> asymmetric_coefficients(DictionaryBuilder& builder, double coulomb_Nm,
                                                 double viscous_Nm_s_rad) {
  std::vector<Coefficient> four;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<double> values(4, 0.0);
    values[k] = 1.0;
    const std::size_t column = builder.add_drag("asymmetric " + std::to_string(k),
                                                effect_with("asymmetric_friction", values));
    four.push_back(beyond(column, k < 2 ? coulomb_Nm : viscous_Nm_s_rad));
  }
  return four;
}

}  // namespace

void add_plain_friction(DictionaryBuilder& builder) {
  builder.coulomb = builder.add_drag("coulomb", effect_with("coulomb_friction", {1.0}));
  const std::size_t viscous = builder.add_drag("viscous", effect_with("viscous_friction", {1.0}));
  const std::size_t drag = builder.add_drag("drag", effect_with("quadratic_drag", {1.0}));
  const double b = builder.stated("viscous_friction"), c = builder.stated("coulomb_friction");
  const double d = builder.stated("quadratic_drag");
  builder.variant("viscous_friction", {beyond(viscous, b)}).stated = {b};
  builder.variant("coulomb_friction", {beyond(builder.coulomb, c)}).stated = {c};
  builder.variant("quadratic_drag", {beyond(drag, d)}).stated = {d};
  const std::vector<Coefficient> four = asymmetric_coefficients(builder, c, b);
  Variant& asymmetric = builder.variant("asymmetric_friction", four);
  asymmetric.replaces = {"coulomb_friction", "viscous_friction"};
  asymmetric.stated = {c, c, b, b};
  // Where speed, or its lack, matters alike in both directions.
  Variant& levels = builder.variant("asymmetric_friction", {four[0], four[1]});
  levels.replaces = {"coulomb_friction"};
  levels.stated = {c, c};
}

}  // namespace torquewright::identification
