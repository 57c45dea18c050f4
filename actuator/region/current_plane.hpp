// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// s(i_q) i_q, with its first and second derivative.
struct SaturatedCurrent {
  double A;
  double slope;
  double bend_1_A;
};
SaturatedCurrent saturated_current(const PhaseModel& model, double q_A);

/// A quantity at one pair of currents, with its first and second derivatives by them.
struct Bent {
  double value = 0.0;
  double d = 0.0, q = 0.0;
  double dd = 0.0, dq = 0.0, qq = 0.0;
};

/// What the bounds of a region are made of, over the plane of currents, at one speed.
/// docs/derivations/motor_region.md section 3.
struct CurrentPlane {
  Bent torque_Nm;
  Bent power_W;  ///< At the bus, eq. (4).
  Bent room_V2;  ///< (c V)^2 - |v|^2: not negative where eq. (6) holds.
};

/// Empty where the supply cannot deliver the power. Requires that the current is not zero.
std::optional<CurrentPlane> current_plane_at(const PhaseModel& model, const Current& current,
                                             double speed_rad_s);

/// The value of room_V2 alone; minus infinity where the supply cannot deliver the power.
double room_V2_at(const PhaseModel& model, const Current& current, double speed_rad_s);

}  // namespace torquewright::actuator
