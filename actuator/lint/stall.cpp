// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"
#include "actuator/lint/torque.hpp"

namespace torquewright::actuator::lint {
namespace {

std::optional<Term> stated_current(const Actuator& document) {
  return sheet_number(document, &Datasheet::stall_current_A, "stall_current_A");
}

/// I = V / R, in the amperes of the torque constant over those of the sheet.
Term current_of_resistance(const Reading& reading) {
  if (reading.stalls_at_peak_current) return peak_current(reading.document);
  return derive([](double volts, double ohms, double amperes) { return volts / (ohms * amperes); },
                phase_voltage(reading.document), phase_resistance(reading.document),
                phase_current(reading, exact(1.0)));
}

std::vector<Reading> limited_readings(const Reading& stated) {
  Reading reading = stated;
  reading.stalls_at_peak_current = true;
  reading.sentence = "stall at the drive's peak current";
  return {reading};
}

std::optional<Term> torque_expected(const Reading& reading) {
  const std::optional<Term> stated = stated_current(reading.document);
  const bool is_stated = stated && !reading.stalls_at_peak_current;
  return sheet_torque(reading, is_stated ? *stated : current_of_resistance(reading));
}

}  // namespace

const Check stall_current = {
    .rule = "stall-current",
    .unit = "A",
    .equation = "V / R",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated_current,
    .expected =
        [](const Reading& reading) { return std::optional(current_of_resistance(reading)); },
    .families = {ohm_readings, speed_readings, ampere_readings, limited_readings},
};

const Check stall_torque = {
    .rule = "stall-torque",
    .unit = "Nm",
    .equation = "eta N Kt I, I the stall current or V / R",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::stall_torque_Nm, "stall_torque_Nm");
        },
    .expected = torque_expected,
    .families = {loss_readings, side_readings, ohm_readings, ampere_readings, limited_readings},
    .further = losses,
};

}  // namespace torquewright::actuator::lint
