// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

enum class Rating {
  kPeak,        ///< Peak current: for seconds.
  kContinuous,  ///< What the stated continuous current and the heat allow for ever.
};

/// The conditions at which a region is asked for; what is left open is the document's own.
struct OperatingConditions {
  Rating rating = Rating::kPeak;
  std::optional<double> bus_voltage_V;    ///< Takes the place of the battery's open circuit.
  std::optional<double> state_of_charge;  ///< 0 empty, 1 full.
  std::optional<double> winding_temperature_K;
};

/// Why the conditions cannot be met with what the document states, a sentence each; empty: they
/// can.
std::vector<std::string> objections(const Actuator& actuator,
                                    const OperatingConditions& conditions);

/// Asked for, or the document's own.
double winding_temperature_K(const Actuator& actuator, const OperatingConditions& conditions);

/// The bus without load: asked for, or the battery's at its charge, or the drive's.
double open_circuit_voltage_V(const Actuator& actuator, const OperatingConditions& conditions);

/// Winding current, in the document's convention, whose copper loss warms the winding to its limit
/// in the long run. Empty without thermal data.
std::optional<double> steady_current_A(const Actuator& actuator);

/// The electrical side under the conditions. Requires that there are no objections.
PhaseModel phase_model_at(const Actuator& actuator, const OperatingConditions& conditions);

}  // namespace torquewright::actuator
