// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::actuator {

/// Which ampere a torque constant counts, and with it every current of the same document.
enum class CurrentConvention {
  kDc,         ///< One equivalent winding: torque Kt i, line R i + Ke w within the bus voltage.
  kPeakPhase,  ///< Amplitude of the phase current.
  kRmsPhase,   ///< Root mean square of the phase current.
};

/// The terminals between which a resistance was measured.
enum class ResistanceConvention { kDc, kPhase, kLineToLine };

/// How the drive makes phase voltages from the bus.
enum class Modulation { kSine, kSvpwm, kSixStep };

/// Inside, every electrical quantity is an amplitude of one phase (docs/notation.md); these are the
/// factors that lead there. Source: docs/derivations/conventions.md eq. (1)...(6).

/// Phase current amplitude per ampere of the convention: 2/sqrt(3), 1, sqrt(2).
double phase_amperes_per_ampere(CurrentConvention convention);

/// Phase resistance per ohm of the convention: 1/2, 1, 1/2.
double phase_ohms_per_ohm(ResistanceConvention convention);

/// Largest phase voltage amplitude per bus volt: V/2, V/sqrt(3), 2 V/pi; under `kDc` the modulation
/// plays no part and it is 1/sqrt(3), so that the equivalent winding sees the whole bus voltage.
double phase_volts_per_bus_volt(CurrentConvention convention, Modulation modulation);

/// Phase voltage amplitude per volt of a back-EMF constant or winding voltage: 1/sqrt(3) for `kDc`
/// (line-to-line peak), 1 otherwise.
double phase_volts_per_winding_volt(CurrentConvention convention);

/// The back-EMF constant that goes with a torque constant of a model without losses, in
/// V s/rad per Nm/A: 1, 2/3, sqrt(2)/3.
double back_emf_per_torque_constant(CurrentConvention convention);

/// The word for it in documents: "dc", "peak_phase", "rms_phase".
std::string_view name_of(CurrentConvention convention);
std::string_view name_of(ResistanceConvention convention);
std::string_view name_of(Modulation modulation);

}  // namespace torquewright::actuator
