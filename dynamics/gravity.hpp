// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::dynamics {

/// Acceleration of gravity: the usual value, not that of a place. From the equator to the poles it
/// goes from 9.780 to 9.832 m/s^2 at sea level (WGS 84), so what is weighed on a bench is known to
/// 0.3 % only.
inline constexpr double kGravity_m_s2 = 9.81;

}  // namespace torquewright::dynamics
