// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"
#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator::lint {
namespace {

/// The declared effects' drag at the joint's no-load speed: at what speed the sheet says, or the
/// motor's constants.
std::optional<double> drag_Nm(const Interpretation& interpretation) {
  const Actuator& document = interpretation.document;
  const std::optional<RoundedInterval> stated_speed =
      sheet_number(document, &Datasheet::no_load_speed_rad_s, "no_load_speed_rad_s");
  const double gear = ratio(document).value;
  const double speed_rad_s =
      stated_speed ? stated_speed->value * sheet_ratio(document, "no_load_speed_rad_s").value / gear
                   : phase_voltage(document).value / (phase_back_emf(interpretation).value * gear);
  const Span torque =
      motor_side_torque_Nm(document, speed_rad_s, 1.0, document.motor.winding_temperature_K);
  const double drag = -0.5 * (torque.least + torque.greatest);
  return drag > 0.0 ? std::optional(drag) : std::nullopt;
}

/// I0 = drag / (N Kt).
std::optional<RoundedInterval> expected(const Interpretation& interpretation) {
  const std::optional<double> drag = drag_Nm(interpretation);
  if (!drag) return std::nullopt;
  const RoundedInterval current_A =
      derive([](double torque_Nm, double turns, double constant_Nm_A,
                double factor) { return torque_Nm / (turns * constant_Nm_A * factor); },
             exact(*drag, "/effects"), ratio(interpretation.document),
             torque_constant(interpretation.document), exact(interpretation.current_factor));
  return printed_amperes(interpretation, current_A, "/datasheet/no_load_current_A");
}

}  // namespace

const Check no_load_current = {
    .rule = "no-load-current",
    .unit = "A",
    .equation = "drag / (N Kt)",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::no_load_current_A, "no_load_current_A");
        },
    .expected = expected,
    .interpreters = {ampere_interpretations},
};

}  // namespace torquewright::actuator::lint
