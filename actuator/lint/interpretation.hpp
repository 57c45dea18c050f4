// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator::lint {

/// How a back-EMF was measured on a machine of sinusoidal EMF.
enum class EmfMeasure { kLinePeak, kPhasePeak, kLineRms, kPhaseRms };

/// Name of a measure: "line-to-line peak", ...
std::string_view name_of(EmfMeasure measure);

/// Volts of the measure per volt of phase amplitude: sqrt(3), 1, sqrt(3/2), sqrt(1/2).
double volts_per_phase_volt(EmfMeasure measure);

/// A document with one reading of its numbers. Nothing in the document is repaired: an
/// interpretation only says what the same numerals would mean elsewhere.
struct Interpretation {
  std::string sentence;  ///< What is read differently, in words; empty: nothing.
  Actuator document;
  EmfMeasure emf_measure = EmfMeasure::kLinePeak;  ///< Measure of back_emf_constant_V_s_rad.
  /// Measure of 1 / velocity_constant_rpm_V.
  EmfMeasure speed_constant_measure = EmfMeasure::kLinePeak;
  double current_factor = 1.0;  ///< Amperes of the torque constant per ampere stated elsewhere.
  bool stalls_at_peak_current = false;  ///< The stall current is the drive's, instead of V / R.
  bool power_is_electrical = false;
  int ratio_power_of_inertia = 2;
};

/// Returns the reading that the document itself states.
Interpretation as_stated(const Actuator& document);

/// A function that returns other interpretations of one kind, without the document's own.
using Interpreter = std::vector<Interpretation> (*)(const Interpretation& stated);

/// Varies the torque constant per dc, peak or rms ampere, with each modulation: the candidate table
/// of speeds. With a stated back-EMF constant, which then sets the speed, each of its measures
/// instead.
std::vector<Interpretation> speed_interpretations(const Interpretation& stated);
/// Varies the torque constant per dc, peak or rms ampere, with each measure of the back-EMF.
std::vector<Interpretation> emf_interpretations(const Interpretation& stated);
/// Varies one thing at a time: another convention (with each modulation), another measure of a
/// stated back-EMF constant, another of a stated velocity constant.
std::vector<Interpretation> convention_interpretations(const Interpretation& stated);
std::vector<Interpretation> measure_interpretations(const Interpretation& stated);
std::vector<Interpretation> speed_measure_interpretations(const Interpretation& stated);
/// Counts currents in another ampere than the torque constant's.
std::vector<Interpretation> ampere_interpretations(const Interpretation& stated);
/// Takes the resistance between other terminals.
std::vector<Interpretation> ohm_interpretations(const Interpretation& stated);
/// Takes the data sheet's numbers on the other side of the gearbox.
std::vector<Interpretation> side_interpretations(const Interpretation& stated);
/// Takes gears without loss.
std::vector<Interpretation> loss_interpretations(const Interpretation& stated);

}  // namespace torquewright::actuator::lint
