// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/lint/interpretation.hpp"
#include "actuator/lint/rounded_interval.hpp"

namespace torquewright::actuator::lint {

/// The numbers of a document as intervals of the checks' equations. Electrical ones are amplitudes
/// of one phase. What is a condition (voltages and currents at which something else is stated) and
/// what is counted (whole ratios, ratios of gearboxes with known teeth, efficiencies of 0 and 1) is
/// exact.

using SheetKey = std::optional<double> Datasheet::*;

/// A number of the data sheet as printed; empty where absent.
std::optional<RoundedInterval> sheet_number(const Actuator& document, SheetKey key,
                                            const char* name);
/// The same as a condition.
std::optional<RoundedInterval> sheet_condition(const Actuator& document, SheetKey key,
                                               const char* name);

/// Magnitude of rotor speed over joint speed.
RoundedInterval ratio(const Actuator& document);
/// Rotor speed over the speed at the data sheet's side: 1 on the motor's.
RoundedInterval sheet_ratio(const Actuator& document);
/// Between the rotor and the data sheet's side: 1 on the motor's.
RoundedInterval sheet_efficiency(const Actuator& document);
RoundedInterval efficiency(double value, const char* pointer);

RoundedInterval torque_constant(const Actuator& document);  ///< As printed, Nm/A.
RoundedInterval phase_torque_constant(
    const Actuator& document);  ///< Per ampere of phase amplitude.
RoundedInterval phase_back_emf(
    const Interpretation& interpretation);  ///< V s/rad; from Kt where it is not stated.
RoundedInterval phase_resistance(const Actuator& document);
/// Largest phase amplitude at the data sheet's voltage, or else the drive's.
RoundedInterval phase_voltage(const Actuator& document);
/// Phase amplitude of a current stated elsewhere than in the torque constant.
RoundedInterval phase_current(const Interpretation& interpretation,
                              const RoundedInterval& current_A);
/// The drive's peak current as a condition.
RoundedInterval peak_current(const Actuator& document);

double product(double one, double other);

}  // namespace torquewright::actuator::lint
