// SPDX-License-Identifier: Apache-2.0
#include "identification/planned_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace torquewright::identification {
namespace {

// Typical values at which effects that are not linear are planned for.
constexpr double kStribeckShare = 0.05;  ///< Of the greatest speed.
constexpr double kPreslidingLength_rad = 0.01;
constexpr double kSaturationExponent = 2.0;
constexpr double kLag_s = 0.008;

/// How far a variant's shape is from the typical one; it is chosen by the least.
double distance(const Variant& variant, const Extent& extent) {
  const auto off = [](double value, double typical) { return std::abs(std::log(value / typical)); };
  if (variant.effect == "stribeck_friction") {
    return variant.coefficients.size() == 2
               ? off(variant.shape[1][0], kStribeckShare * extent.speed_rad_s)
               : 1e9;
  }
  if (variant.effect == "torque_constant_saturation") {
    const bool is_plain = variant.shape.size() == 1 && variant.shape[0][1] == kSaturationExponent;
    return is_plain ? off(variant.shape[0][0], extent.current_A) : 1e9;
  }
  if (variant.effect == "presliding_friction") {
    return variant.shape.size() == 1 ? off(variant.shape[0][0], kPreslidingLength_rad) : 1e9;
  }
  if (variant.effect == "torque_lag") return off(variant.shape[0][0], kLag_s);
  return 0.0;
}

const Variant* typical_variant(const Dictionary& dictionary, const Extent& extent,
                               const std::string& effect) {
  const Variant* best = nullptr;
  for (const Variant& variant : dictionary.variants) {
    if (variant.effect != effect) continue;
    if (best == nullptr || distance(variant, extent) < distance(*best, extent)) best = &variant;
  }
  return best;
}

const std::map<std::string, std::vector<std::string>>& parameter_names() {
  static const std::map<std::string, std::vector<std::string>> names = {
      {"viscous_friction", {"viscous_Nm_s_rad"}},
      {"coulomb_friction", {"coulomb_Nm"}},
      {"quadratic_drag", {"drag_Nm_s2_rad2"}},
      {"load_dependent_friction", {"driving_coefficient", "backdriving_coefficient"}},
      {"presliding_friction", {"coulomb_Nm"}},
      {"torque_constant_saturation", {"share"}},
      {"torque_constant_temperature", {"coefficient_1_K"}},
      {"friction_temperature", {"coefficient_1_K"}},
      {"winding_resistance_temperature", {"coefficient_1_K"}},
      {"torque_constant_error", {"factor"}},
      {"reflected_inertia", {"inertia_kg_m2"}},
      {"torque_lag", {"share"}},
      {"channel_delay", {"delay_s"}},
      {"inverter_dead_time", {"voltage_V"}},
      {"torque_offset", {"value_Nm"}}};
  return names;
}

PlannedColumn column_of(const std::string& effect, std::string parameter, std::string at,
                        std::vector<Coefficient::Term> terms) {
  return {effect, std::move(parameter), std::move(at), std::move(terms)};
}

std::vector<Coefficient::Term> difference(const Coefficient& a, const Coefficient& b) {
  return {{a.terms[0].column, 0.5}, {b.terms[0].column, -0.5}};
}

std::string typical_values(const Variant& variant) {
  if (variant.effect == "torque_constant_saturation") {
    return fmt::format("of a saturation at {:.3g} A, exponent {:g}", variant.shape[0][0],
                       variant.shape[0][1]);
  }
  if (variant.effect == "presliding_friction") {
    return fmt::format("at a presliding length of {:.3g} rad", variant.shape[0][0]);
  }
  if (variant.effect == "torque_lag") {
    return fmt::format("of a lag of {:.3g} s", variant.shape[0][0]);
  }
  return "";
}

}  // namespace

std::vector<PlannedColumn> planned_columns(const Dictionary& dictionary, const Extent& extent,
                                           const std::string& effect) {
  const Variant* variant = typical_variant(dictionary, extent, effect);
  if (variant == nullptr) return {};
  const auto& fitted = variant->coefficients;
  if (effect == "stribeck_friction") {
    return {column_of(effect, "breakaway_over_coulomb_Nm",
                      fmt::format("at a Stribeck velocity of {:.3g} rad/s", variant->shape[1][0]),
                      fitted[1].terms)};
  }
  if (effect == "asymmetric_friction") {
    // What both directions have in common is Coulomb and viscous friction.
    return {column_of(effect, "coulomb_difference_Nm", "", difference(fitted[0], fitted[1])),
            column_of(effect, "viscous_difference_Nm_s_rad", "", difference(fitted[2], fitted[3]))};
  }
  if (variant->scales_friction) {
    if (dictionary.nominal_drag_warmed == Dictionary::kNone) return {};
    return {column_of(effect, "coefficient_1_K", "", {{dictionary.nominal_drag_warmed, 1.0}})};
  }
  std::vector<PlannedColumn> columns;
  const auto names = parameter_names().find(effect);
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    std::string name = names == parameter_names().end()
                           ? fmt::format("{}_{:g}_Nm", k == 0 ? "sine" : "cosine", variant->order)
                           : names->second[std::min(k, names->second.size() - 1)];
    columns.push_back(
        column_of(effect, std::move(name), typical_values(*variant), fitted[k].terms));
  }
  return columns;
}

const std::vector<std::string>& effects_of_the_contract() {
  static const std::vector<std::string> names = {"viscous_friction",
                                                 "coulomb_friction",
                                                 "stribeck_friction",
                                                 "asymmetric_friction",
                                                 "quadratic_drag",
                                                 "load_dependent_friction",
                                                 "presliding_friction",
                                                 "torque_constant_saturation",
                                                 "torque_constant_temperature",
                                                 "friction_temperature",
                                                 "cogging_torque",
                                                 "gear_ripple",
                                                 "position_dependent_friction",
                                                 "backlash",
                                                 "torsional_compliance",
                                                 "reflected_inertia",
                                                 "torque_lag",
                                                 "voltage_sag",
                                                 "winding_resistance_temperature",
                                                 "inverter_dead_time",
                                                 "torque_constant_error",
                                                 "gravity_imbalance",
                                                 "load_inertia_error",
                                                 "load_mass_error",
                                                 "channel_delay",
                                                 "torque_offset",
                                                 "current_offset",
                                                 "velocity_mismatch"};
  return names;
}

Eigen::MatrixXd planned_rows(const Signals& signals, const Dictionary& dictionary,
                             const std::vector<PlannedColumn>& columns, const Target& target,
                             const BandOptions& options, Eigen::VectorXd* residual) {
  std::vector<std::size_t> used;
  for (const PlannedColumn& column : columns) {
    for (const Coefficient::Term& term : column.terms) used.push_back(term.column);
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<const Column*> pointers;
  for (const std::size_t index : used) pointers.push_back(&dictionary.columns[index]);
  const BandRows rows = band_rows(signals, pointers, target, options);
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(rows.values.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const Coefficient::Term& term : columns[c].terms) {
      const auto at = std::lower_bound(used.begin(), used.end(), term.column) - used.begin();
      values.col(static_cast<Eigen::Index>(c)) += term.weight * rows.values.col(at);
    }
  }
  if (residual != nullptr) *residual = rows.values.rightCols(1);
  return values;
}

}  // namespace torquewright::identification
