// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/motor/phase_model.hpp"

namespace torquewright::oracles {

struct TorqueRange {
  double least_Nm;
  double greatest_Nm;
};

/// Brute force over a polar grid of (i_d, i_q): every current is tried against its limit, the
/// demagnetisation limit, the voltage with the bus that its own power leaves, and the power limits.
/// Equations written anew from the reference (actuator.md 2.2), sharing nothing with the search.
/// Without field weakening only i_d = 0 is tried (equal inductances). No saturation, no dead time.
std::optional<TorqueRange> brute_force_range(const actuator::PhaseModel& model, double speed_rad_s,
                                             int rings, int rays);

}  // namespace torquewright::oracles
