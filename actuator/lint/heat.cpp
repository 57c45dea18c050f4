// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"
#include "actuator/lint/torque.hpp"
#include "actuator/region/operating_conditions.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr const char* kContinuous = "/drive/continuous_current_A";

/// Thermal resistance to the ambient. A case held at ambient has none of its own.
RoundedInterval to_ambient(const Thermal& thermal) {
  return derive([](double inner, double outer) { return inner + outer; },
                rounded(thermal.winding_to_case_K_W, "/thermal/winding_to_case_K_W"),
                rounded(thermal.case_to_ambient_K_W, "/thermal/case_to_ambient_K_W"));
}

RoundedInterval room(const Thermal& thermal) {
  return derive([](double limit_K, double ambient_K) { return std::max(0.0, limit_K - ambient_K); },
                rounded(thermal.winding_limit_K, "/thermal/winding_limit_K"),
                exact(thermal.ambient_K, "/thermal/ambient_K"));
}

/// steady_current_A, which goes with the root of (T_limit - T_ambient) / (R_th R).
std::optional<RoundedInterval> steady_current(const Interpretation& interpretation) {
  const Actuator& document = interpretation.document;
  const std::optional<double> nominal_A = steady_current_A(document);
  if (!nominal_A) return std::nullopt;
  const RoundedInterval room_K = room(*document.thermal);
  const RoundedInterval resistance_K_W = to_ambient(*document.thermal);
  const RoundedInterval ohms = phase_resistance(document);
  const double scale_A = *nominal_A / interpretation.current_factor /
                         std::sqrt(room_K.value / (resistance_K_W.value * ohms.value));
  return derive([scale_A](double kelvin, double kelvin_W,
                          double ohm) { return scale_A * std::sqrt(kelvin / (kelvin_W * ohm)); },
                room_K, resistance_K_W, ohms);
}

std::vector<Interpretation> cooled_interpretations(const Interpretation& stated) {
  if (!stated.document.thermal) return {};
  Interpretation interpretation = stated;
  interpretation.document.thermal->case_to_ambient_K_W = 0.0;
  interpretation.sentence = "with the case held at ambient temperature";
  return {interpretation};
}

}  // namespace

const Check continuous_current = {
    .rule = "continuous-current",
    .unit = "A",
    .equation = "root of (T_limit - T_ambient) / (R_th R), R at T_limit",
    .demand = Demand::kAtMost,
    .weight = Weight::kContradiction,
    .stated = [](const Actuator& document) -> std::optional<RoundedInterval> {
      if (!document.drive.continuous_current_A) return std::nullopt;
      return printed(document, *document.drive.continuous_current_A, kContinuous);
    },
    .expected = [](const Interpretation& interpretation) -> std::optional<RoundedInterval> {
      const std::optional<RoundedInterval> steady_A = steady_current(interpretation);
      if (!steady_A) return std::nullopt;
      return printed_amperes(interpretation, *steady_A, kContinuous);
    },
    .interpreters = {cooled_interpretations, ampere_interpretations, ohm_interpretations},
};

const Check rated_torque_heat = {
    .rule = "rated-torque-heat",
    .unit = "Nm",
    .equation = "eta N Kt I, I the current that the heat allows for ever",
    .demand = Demand::kAtMost,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::rated_torque_Nm, "rated_torque_Nm");
        },
    .expected = [](const Interpretation& interpretation) -> std::optional<RoundedInterval> {
      const std::optional<RoundedInterval> current_A = steady_current(interpretation);
      if (!current_A) return std::nullopt;
      return sheet_torque(interpretation, *current_A, "rated_torque_Nm");
    },
    .interpreters = {cooled_interpretations, ohm_interpretations, side_interpretations,
                     loss_interpretations},
};

}  // namespace torquewright::actuator::lint
