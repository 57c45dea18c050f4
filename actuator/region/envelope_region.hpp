// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// The curve of a drive at its rotor: `curve` of its document, speeds in proportion to the bus
/// voltage where the document says at which one it holds. Of a curve that includes losses: what the
/// rotor must have so that the curve is what leaves the joint. Requires a drive with an envelope.
/// docs/derivations/envelopes.md eq. (1) to (3).
EnvelopeCurve rotor_envelope(const Actuator& actuator, EnvelopeCurve curve, double bus_V,
                             double temperature_K);

}  // namespace torquewright::actuator
