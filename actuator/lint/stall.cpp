// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"
#include "actuator/lint/supply_voltage.hpp"
#include "actuator/lint/torque.hpp"

namespace torquewright::actuator::lint {
namespace {

std::optional<RoundedInterval> stated_current(const Actuator& document) {
  return sheet_number(document, &Datasheet::stall_current_A, "stall_current_A");
}

constexpr const char* kStallCurrent = "/datasheet/stall_current_A";

std::optional<StallLimit> limit_of(const Actuator& document) {
  return document.datasheet ? document.datasheet->stall_limit : std::nullopt;
}

/// I = V / R, in the amperes of the torque constant over those of the sheet.
RoundedInterval current_of_resistance(const Interpretation& interpretation) {
  return derive([](double volts, double ohms, double amperes) { return volts / (ohms * amperes); },
                phase_voltage(interpretation.document), phase_resistance(interpretation.document),
                phase_current(interpretation, exact(1.0)));
}

/// What flows at stall, as far as the stall current is not stated.
RoundedInterval current_at_stall(const Interpretation& interpretation) {
  const bool is_limited = interpretation.stalls_at_peak_current ||
                          limit_of(interpretation.document) == StallLimit::kDrive;
  return is_limited ? peak_current(interpretation) : current_of_resistance(interpretation);
}

/// The drive's limit may be anything up to what the resistance lets through.
std::optional<RoundedInterval> current_expected(const Interpretation& interpretation) {
  if (interpretation.stalls_at_peak_current) {
    return printed_amperes(interpretation, peak_current(interpretation), kStallCurrent);
  }
  RoundedInterval expected =
      printed_amperes(interpretation, current_of_resistance(interpretation), kStallCurrent);
  if (limit_of(interpretation.document) == StallLimit::kDrive) expected.low = 0.0;
  return expected;
}

/// Unless the document says what limits it.
std::vector<Interpretation> limited_interpretations(const Interpretation& stated) {
  if (limit_of(stated.document)) return {};
  Interpretation interpretation = stated;
  interpretation.stalls_at_peak_current = true;
  interpretation.sentence = "stall at the drive's peak current";
  return {interpretation};
}

std::optional<RoundedInterval> torque_expected(const Interpretation& interpretation) {
  const std::optional<RoundedInterval> stated = stated_current(interpretation.document);
  const bool is_stated = stated && !interpretation.stalls_at_peak_current;
  const RoundedInterval amperes =
      is_stated ? torque_constant_amperes(interpretation, *stated, kStallCurrent)
                : current_at_stall(interpretation);
  return sheet_torque(interpretation, less_drag(interpretation, amperes), "stall_torque_Nm");
}

}  // namespace

const Check stall_current = {
    .rule = "stall-current",
    .unit = "A",
    .equation = "V / R",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated_current,
    .expected = current_expected,
    .interpreters = {ohm_interpretations, speed_interpretations, ampere_interpretations,
                     limited_interpretations},
    .further = other_voltage,
    .tolerance = catalogue,
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
    .interpreters = {loss_interpretations, side_interpretations, ohm_interpretations,
                     ampere_interpretations, limited_interpretations},
    .further = losses,
    .tolerance = peak_torques,
};

}  // namespace torquewright::actuator::lint
