// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/relaxation.hpp"

namespace torquewright::gearbox::proof {

/// constant + slope . x
Linearization affine(const RealPoint& point, const Interval& constant,
                     const std::array<Interval, 3>& slope);

/// z - min
Linearization min_teeth_form(const Alternative& alternative, std::size_t gear,
                             const RealPoint& point);

/// k S - (1 - k) P1 with k = sin(pi/n - alpha_min), the angle brought into [-pi/2, pi/2], where the
/// sine grows: beyond it the constraint holds (fails) for all teeth, and so does the form.
Linearization carrier_clearance_form(const Alternative& alternative, const RealPoint& point);

/// (S + P1) sin(pi/n) - (P + 2) - limit/m
Linearization neighbour_clearance_form(const Alternative& alternative, std::size_t layer,
                                       const RealPoint& point);

/// Concave for G' >= 1 only, else empty. Planetary: linear.
std::optional<Linearization> ratio_max_form(const Alternative& alternative, const RealPoint& point);
std::optional<Linearization> ratio_min_form(const Alternative& alternative, const Box& box,
                                            const RealPoint& point);

/// J - 1/S_u^2 - (S + 2 P1 - D/m)^2 - P1^2 - P2^2 - (S + P1 + P2)^2
Linearization paper_cost_form(const Alternative& alternative, const Interval& threshold,
                              const Box& box, const RealPoint& point);

/// threshold - mass in kg
Linearization mass_form(const Alternative& alternative, const Interval& threshold, const Box& box,
                        const RealPoint& point);

}  // namespace torquewright::gearbox::proof
