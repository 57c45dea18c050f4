// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/region/motor_region.hpp"
#include "actuator/region/operating_conditions.hpp"

namespace torquewright::actuator {

/// The curve of a drive at its rotor: what its document states at that rating, its speeds in
/// proportion to the bus voltage where the document says at which one it holds. Of a curve that
/// includes losses: what the rotor must have so that the curve is what leaves the joint. Requires a
/// drive with an envelope, and one that lasts where that is what is asked for.
/// docs/derivations/envelopes.md eq. (1) to (3).
EnvelopeCurve rotor_envelope(const Actuator& actuator, Rating rating, double bus_V,
                             double temperature_K);

/// What such a drive can do at a speed of its rotor; empty beyond its curve. Requires a model with
/// an envelope.
MotorRange envelope_range(const PhaseModel& model, double speed_rad_s);

/// The electrical side of a drive of which only the curve is known: its currents are torques, and
/// neither heat nor losses follow from it.
PhaseModel envelope_model(const Actuator& actuator, const OperatingConditions& conditions);

}  // namespace torquewright::actuator
