// SPDX-License-Identifier: Apache-2.0
// Friction that builds up over a small motion after each reversal.
#include <algorithm>
#include <cmath>

#include "identification/effects/families.hpp"

namespace torquewright::identification {
namespace {

/// The state's law along the recorded motion, by its exact solution between samples: it relaxes
/// towards the direction's friction over the presliding length.
std::size_t add_column(DictionaryBuilder& builder, double length_rad) {
  const actuator::Effect effect = effect_with("presliding_friction", {1.0, 1.0 / length_rad});
  return builder.add_stretch("presliding", [effect, balance = builder.balance(), length_rad](
                                               const Signals& signals, std::vector<double>& out) {
    actuator::Instant at;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (i > 0) {
        const double moved = signals.at[i].output_angle_rad - signals.at[i - 1].output_angle_rad;
        const double goal = moved > 0.0 ? 1.0 : -1.0;
        at.state = goal + (at.state - goal) * std::exp(-std::abs(moved) / length_rad);
      }
      out[i] = balance->gain(signals, i) * effect.kind->law(effect, at);
    }
  });
}

void add_variant(DictionaryBuilder& builder, const std::vector<std::size_t>& columns,
                 std::vector<std::vector<double>> shape) {
  std::vector<Coefficient> coefficients;
  for (const std::size_t column : columns) coefficients.push_back(one(column, 0.0, kInfinity));
  // It takes the place of Coulomb friction that is stated.
  const double c = builder.stated("coulomb_friction");
  if (c > 0.0) coefficients.push_back(takes_away(builder.coulomb, c));
  Variant& added = builder.variant("presliding_friction", std::move(coefficients));
  added.shape = std::move(shape);
  added.replaces = {"coulomb_friction"};
}

}  // namespace

void add_presliding(DictionaryBuilder& builder) {
  const double stroke_rad = std::max(builder.extent().output_angle_rad, 1e-3);
  const std::vector<double> lengths = geometric(1e-3 * stroke_rad, 0.3 * stroke_rad, 10);
  std::vector<std::size_t> columns;
  for (const double length_rad : lengths) columns.push_back(add_column(builder, length_rad));
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    add_variant(builder, {columns[k]}, {{lengths[k]}});
    if (k + 1 == lengths.size()) continue;
    add_variant(builder, {columns[k], columns[k + 1]}, {{lengths[k]}, {lengths[k + 1]}});
  }
}

}  // namespace torquewright::identification
