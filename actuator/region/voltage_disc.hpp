// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// Where L_d = L_q and neither battery nor bridge bends it, the voltage limit is a disc in the
/// plane of currents, as the current limit is, and the bounds are where two circles meet.
/// docs/derivations/motor_region.md eq. (9).
struct VoltageDisc {
  double d_A = 0.0;  ///< Centre; never positive.
  double q_A = 0.0;
  double radius_A = 0.0;
};

/// Empty where the voltage limit is no disc. `slack_V` is added to the voltage.
std::optional<VoltageDisc> voltage_disc(const PhaseModel& model, double speed_rad_s,
                                        double slack_V);

/// An end of the currents that both limits allow.
struct DiscEnd {
  Current current;
  bool by_current_limit = false;  ///< Else the voltage ends them.
};
struct DiscRange {
  bool is_empty = false;
  DiscEnd least;
  DiscEnd greatest;
};

/// The range from the least to the greatest q current that the limits of voltage, current and
/// demagnetisation allow. Empty optional: the closed forms do not tell (a corner at the
/// demagnetisation limit).
std::optional<DiscRange> disc_range(const VoltageDisc& disc, const PhaseModel& model);

/// The d current nearest to zero and not below `floor_A` that the voltage allows together with
/// the q current; where none does, the one that leaves least voltage missing.
double nearest_d_A(const VoltageDisc& disc, double q_A, double floor_A);

}  // namespace torquewright::actuator
