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

/// Returns a number as printed, within its rounding or the tolerance that is stated with it; of one
/// that is stated as a bound all that lies on its side.
RoundedInterval printed(const Actuator& document, double value, const char* pointer);

/// Returns the number as a condition at which something else is stated: exact but for a stated
/// tolerance.
RoundedInterval condition(const Actuator& document, double value, const char* pointer);

/// Returns a number of the data sheet as printed; empty where absent.
std::optional<RoundedInterval> sheet_number(const Actuator& document, SheetKey key,
                                            const char* name);
/// Returns a number of the data sheet as a condition; empty where absent.
std::optional<RoundedInterval> sheet_condition(const Actuator& document, SheetKey key,
                                               const char* name);

/// Magnitude of rotor speed over joint speed.
RoundedInterval ratio(const Actuator& document);
/// Rotor speed over the speed at the side of a number of the data sheet: 1 on the motor's.
RoundedInterval sheet_ratio(const Actuator& document, const char* name);
/// Efficiency between the rotor and the side of a number of the data sheet: 1 on the motor's.
RoundedInterval sheet_efficiency(const Actuator& document, const char* name);
/// Torque per ampere of the torque constant at the side of a number of the data sheet.
RoundedInterval sheet_torque_constant(const Actuator& document, const char* name);
/// The least share of their stated torque that gears of unknown efficiency leave.
double least_share_of_gears(const Actuator& document);
RoundedInterval efficiency(double value, const char* pointer);

/// Torque constant at the motor, in Nm/A; from one at the joint without what the gears may have
/// taken.
RoundedInterval torque_constant(const Actuator& document);
RoundedInterval phase_torque_constant(
    const Actuator& document);  ///< Per ampere of phase amplitude.
/// The back-EMF constant as the sheet prints it, at the motor; empty where the document states none
/// and it follows from the torque constant.
std::optional<RoundedInterval> stated_back_emf(const Actuator& document);
RoundedInterval phase_back_emf(
    const Interpretation& interpretation);  ///< V s/rad; from Kt where it is not stated.
RoundedInterval phase_resistance(const Actuator& document);
/// Largest phase amplitude at the data sheet's voltage, or else the drive's.
RoundedInterval phase_voltage(const Actuator& document);
/// A printed current in amperes of the torque constant, over `current_factor`; where it says no
/// ampere of its own, these are the amperes that it is printed in.
RoundedInterval torque_constant_amperes(const Interpretation& interpretation,
                                        const RoundedInterval& current_A, const char* pointer);
/// Converts a current in those amperes to the pointer's own amperes, as it would be printed.
RoundedInterval printed_amperes(const Interpretation& interpretation,
                                const RoundedInterval& current_A, const char* pointer);

/// Phase amplitude of a current that is stated elsewhere than in the torque constant.
RoundedInterval phase_current(const Interpretation& interpretation,
                              const RoundedInterval& current_A);
/// The drive's peak current as a condition, in amperes of the torque constant over
/// `current_factor`.
RoundedInterval peak_current(const Interpretation& interpretation);

/// Largest d current against the magnets, in the same amperes.
RoundedInterval demagnetisation_current(const Interpretation& interpretation);
RoundedInterval inductance_d(const Actuator& document);
RoundedInterval inductance_q(const Actuator& document);

double product(double one, double other);

}  // namespace torquewright::actuator::lint
