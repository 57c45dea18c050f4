// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"
#include "actuator/lint/supply_voltage.hpp"

namespace torquewright::actuator::lint {
namespace {

std::optional<RoundedInterval> stated(const Actuator& document) {
  return sheet_number(document, &Datasheet::no_load_speed_rad_s, "no_load_speed_rad_s");
}

/// What the stated no-load current takes of the phase voltage: nothing where none is stated.
RoundedInterval voltage_drop(const Interpretation& interpretation) {
  const std::optional<RoundedInterval> current_A =
      sheet_number(interpretation.document, &Datasheet::no_load_current_A, "no_load_current_A");
  if (!current_A) return exact(0.0);
  return derive(
      product, phase_resistance(interpretation.document),
      phase_current(interpretation, torque_constant_amperes(interpretation, *current_A,
                                                            "/datasheet/no_load_current_A")));
}

/// Back-EMF per speed once the d current takes what it can from the magnet's flux: Ke - p L_d i.
RoundedInterval weakened_back_emf(const Interpretation& interpretation) {
  const Motor& motor = interpretation.document.motor;
  const double limit_A =
      std::min(peak_current(interpretation).value, demagnetisation_current(interpretation).value);
  return derive(
      [](double back_emf, double inductance_H, double pole_pairs, double current_A) {
        return std::max(0.0, back_emf - pole_pairs * inductance_H * current_A);
      },
      phase_back_emf(interpretation), inductance_d(interpretation.document),
      exact(motor.pole_pairs, "/motor/pole_pairs"),
      phase_current(interpretation, exact(limit_A, "/drive/peak_current_A")));
}

/// w0 = (V - R I0) / (Ke N); with field weakening, anything up to the weakened field's.
RoundedInterval speed_without_load(const Interpretation& interpretation, const char* name) {
  const auto with = [&](const RoundedInterval& back_emf) {
    return derive([](double volts, double drop_V, double emf,
                     double turns) { return (volts - drop_V) / (emf * turns); },
                  phase_voltage(interpretation.document), voltage_drop(interpretation), back_emf,
                  sheet_ratio(interpretation.document, name));
  };
  RoundedInterval speed = with(phase_back_emf(interpretation));
  if (!interpretation.document.drive.field_weakening) return speed;
  const RoundedInterval weakened = with(weakened_back_emf(interpretation));
  speed.high = weakened.high;
  speed.pointers = united(speed.pointers, {"/drive/field_weakening"});
  speed.pointers = united(speed.pointers, weakened.pointers);
  return speed;
}

}  // namespace

const Check no_load_speed = {
    .rule = "no-load-speed",
    .unit = "rad/s",
    .equation = "(V - R I0) / (Ke N)",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated,
    .expected =
        [](const Interpretation& interpretation) {
          return std::optional(speed_without_load(interpretation, "no_load_speed_rad_s"));
        },
    .interpreters = {speed_interpretations, side_interpretations},
    .below_is_load = true,
    .further = other_voltage,
    .tolerance = speeds,
};

const Check maximum_speed = {
    .rule = "maximum-speed",
    .unit = "rad/s",
    .equation = "the no-load speed, (V - R I0) / (Ke N)",
    .demand = Demand::kAtMost,
    .weight = Weight::kPlausibility,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::maximum_speed_rad_s, "maximum_speed_rad_s");
        },
    .expected =
        [](const Interpretation& interpretation) {
          return std::optional(speed_without_load(interpretation, "maximum_speed_rad_s"));
        },
    .interpreters = {},
    .tolerance = catalogue,
};

}  // namespace torquewright::actuator::lint
