// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

std::optional<Term> stated(const Actuator& document) {
  return sheet_number(document, &Datasheet::no_load_speed_rad_s, "no_load_speed_rad_s");
}

/// What the stated no-load current takes of the phase voltage: nothing where none is stated.
Term voltage_drop(const Reading& reading) {
  const std::optional<Term> current_A =
      sheet_number(reading.document, &Datasheet::no_load_current_A, "no_load_current_A");
  if (!current_A) return exact(0.0);
  return derive(product, phase_resistance(reading.document), phase_current(reading, *current_A));
}

/// Back-EMF per speed once the d current takes what it can from the magnet's flux: Ke - p L_d i.
Term weakened_back_emf(const Reading& reading) {
  const Motor& motor = reading.document.motor;
  const double limit_A =
      std::min(reading.document.drive.peak_current_A, motor.demagnetisation_current_A);
  return derive(
      [](double back_emf, double inductance_H, double pole_pairs, double current_A) {
        return std::max(0.0, back_emf - pole_pairs * inductance_H * current_A);
      },
      phase_back_emf(reading), rounded(motor.inductance_d_H, "/motor/inductance_d_H"),
      exact(motor.pole_pairs, "/motor/pole_pairs"),
      phase_current(reading, exact(limit_A, "/drive/peak_current_A")));
}

/// w0 = (V - R I0) / (Ke N); with field weakening, anything up to the weakened field's.
std::optional<Term> expected(const Reading& reading) {
  const auto with = [&](const Term& back_emf) {
    return derive([](double volts, double drop_V, double emf,
                     double turns) { return (volts - drop_V) / (emf * turns); },
                  phase_voltage(reading.document), voltage_drop(reading), back_emf,
                  sheet_ratio(reading.document));
  };
  Term speed = with(phase_back_emf(reading));
  if (!reading.document.drive.field_weakening) return speed;
  const Term weakened = with(weakened_back_emf(reading));
  speed.high = weakened.high;
  speed.pointers = united(speed.pointers, {"/drive/field_weakening"});
  speed.pointers = united(speed.pointers, weakened.pointers);
  return speed;
}

/// The share by which the field would have to be weakened; with field weakening stated, what it can
/// do is in `reached` already.
std::vector<Explanation> further(const Actuator& document, const Term& printed,
                                 const Term& reached) {
  if (document.drive.field_weakening || reached.low <= 0.0) return {};
  if (!lies_above(printed, reached)) return {};
  const Term share =
      derive([](double is, double was) { return 100.0 * (is / was - 1.0); }, printed, reached);
  return {{fmt::format("field weakening by {:.1f} % ({:.1f} to {:.1f} %)", share.value, share.low,
                       share.high),
           std::nullopt, Fit::kFits}};
}

}  // namespace

const Check no_load_speed = {
    .rule = "no-load-speed",
    .unit = "rad/s",
    .equation = "(V - R I0) / (Ke N)",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated,
    .expected = expected,
    .families = {speed_readings, side_readings},
    .below_is_load = true,
    .further = further,
};

}  // namespace torquewright::actuator::lint
