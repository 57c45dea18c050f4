// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "actuator/conditions.hpp"
#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"
#include "actuator/lint/torque.hpp"

namespace torquewright::actuator::lint {
namespace {

/// Thermal resistance to the ambient. A case held at ambient has none of its own.
Term to_ambient(const Thermal& thermal) {
  return derive([](double inner, double outer) { return inner + outer; },
                rounded(thermal.winding_to_case_K_W, "/thermal/winding_to_case_K_W"),
                rounded(thermal.case_to_ambient_K_W, "/thermal/case_to_ambient_K_W"));
}

Term room(const Thermal& thermal) {
  return derive([](double limit_K, double ambient_K) { return std::max(0.0, limit_K - ambient_K); },
                rounded(thermal.winding_limit_K, "/thermal/winding_limit_K"),
                exact(thermal.ambient_K, "/thermal/ambient_K"));
}

/// steady_current_A, which goes with the root of (T_limit - T_ambient) / (R_th R).
std::optional<Term> steady_current(const Reading& reading) {
  const Actuator& document = reading.document;
  const std::optional<double> nominal_A = steady_current_A(document);
  if (!nominal_A) return std::nullopt;
  const Term room_K = room(*document.thermal);
  const Term resistance_K_W = to_ambient(*document.thermal);
  const Term ohms = phase_resistance(document);
  const double scale_A = *nominal_A / reading.current_factor /
                         std::sqrt(room_K.value / (resistance_K_W.value * ohms.value));
  return derive([scale_A](double kelvin, double kelvin_W,
                          double ohm) { return scale_A * std::sqrt(kelvin / (kelvin_W * ohm)); },
                room_K, resistance_K_W, ohms);
}

std::vector<Reading> cooled_readings(const Reading& stated) {
  if (!stated.document.thermal) return {};
  Reading reading = stated;
  reading.document.thermal->case_to_ambient_K_W = 0.0;
  reading.sentence = "with the case held at ambient temperature";
  return {reading};
}

}  // namespace

const Check continuous_current = {
    .rule = "continuous-current",
    .unit = "A",
    .equation = "root of (T_limit - T_ambient) / (R_th R), R at T_limit",
    .demand = Demand::kAtMost,
    .weight = Weight::kContradiction,
    .stated = [](const Actuator& document) -> std::optional<Term> {
      if (!document.drive.continuous_current_A) return std::nullopt;
      return rounded(*document.drive.continuous_current_A, "/drive/continuous_current_A");
    },
    .expected = steady_current,
    .families = {cooled_readings, ampere_readings, ohm_readings},
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
    .expected = [](const Reading& reading) -> std::optional<Term> {
      const std::optional<Term> current_A = steady_current(reading);
      if (!current_A) return std::nullopt;
      return sheet_torque(reading, *current_A);
    },
    .families = {cooled_readings, ohm_readings, side_readings, loss_readings},
};

}  // namespace torquewright::actuator::lint
