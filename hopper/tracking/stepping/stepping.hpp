// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hopper/tracking/controller_kind.hpp"

namespace torquewright::hopper {

/// The share of the speed that a hop lacked by which the next one is asked to be faster. The
/// hopper's hops answer 1 m/s more with 1.7 (docs/survival.md): of what is lacking half is left by
/// each hop.
inline constexpr double kSpeedShare = 0.3;

/// How far a commanded speed may be from that of the motion, in m/s: the law is of small changes of
/// its hops.
inline constexpr double kFarthestSpeed_m_s = 0.4;

/// Mean velocity of the base, in m/s along the way that it faces, from a motion's first landing to
/// its last; 0 where it lands less than twice.
double hopping_speed_m_s(const Robot& robot, const Reference& reference);

/// Raibert's law of stepping on a regulator of the motion: it is shown a robot that goes slower by
/// so much as hops are to go faster, and puts the foot where that is mended. By how much is
/// corrected at each landing, by the speed of the hop that ended (docs/derivations/tracking.md,
/// "Stepping"). Before the first landing and from the last on the motion is followed as it is.
/// Robot and reference must outlive it.
std::unique_ptr<Controller> stepping_controller(const Robot& robot, const Reference& reference,
                                                const ClockOptions& clock, double forward_m_s,
                                                std::unique_ptr<Controller> regulator);

}  // namespace torquewright::hopper
