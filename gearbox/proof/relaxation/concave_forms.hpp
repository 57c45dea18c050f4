// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/relaxation/linearization.hpp"

namespace torquewright::gearbox::proof {

/// constant + slope . x
Linearization affine(const RealPoint& point, const Interval& constant,
                     const std::array<Interval, 3>& slope);

/// -weight (slope . x + constant)^2
Linearization negative_square(const RealPoint& point, const Interval& weight,
                              const Interval& constant, const std::array<Interval, 3>& slope);

/// slope z + constant, z the teeth of gear 0 (sun), 1 or 2 (planet_2 = P1 - d).
Linearization teeth_form(const Interval& slope, const Interval& constant, int gear,
                         const RealPoint& point);

/// slope z + constant, z the teeth of the ring of layer 1 or 2.
Linearization ring_form(const Interval& slope, const Interval& constant, int layer,
                        const RealPoint& point);

/// z - min
Linearization min_teeth_form(const Alternative& alternative, int gear, const RealPoint& point);

/// k S - (1 - k) P1 with k = sin(pi/n - alpha_min), the angle brought into [-pi/2, pi/2], where the
/// sine grows: beyond it the constraint holds (fails) for all teeth, and so does the form.
Linearization carrier_clearance_form(const Alternative& alternative, const RealPoint& point);

/// (S + P1) sin(pi/n) - (P + 2) - limit/m
Linearization neighbour_clearance_form(const Alternative& alternative, int layer,
                                       const RealPoint& point);

/// z - 2/sin^2 alpha
Linearization undercut_form(const Problem& problem, int gear, const RealPoint& point);

/// m (d/2 - 2)
Linearization sun_under_layer_2_form(const Alternative& alternative, const RealPoint& point);

/// (ring_outer_diameter - m (z + 2 h))/2 - wall
Linearization ring_wall_form(const Alternative& alternative, int layer, const RealPoint& point);

/// m (z - 2 - z cos alpha)/2
Linearization ring_tip_form(const Alternative& alternative, int layer, const RealPoint& point);

/// z less the fewest teeth into which the shaper can be fed
Linearization shaper_feed_form(const Alternative& alternative, int layer, const RealPoint& point);

/// Concave for G' >= 1 only, else empty. Planetary: linear.
std::optional<Linearization> ratio_max_form(const Alternative& alternative, const RealPoint& point);
std::optional<Linearization> ratio_min_form(const Alternative& alternative, const Box& box,
                                            const RealPoint& point);

/// J - 1/S_u^2 - (S + 2 P1 - D/m)^2 - P1^2 - (P1 - d)^2 - (S + 2 P1 - d)^2
Linearization paper_cost_form(const Alternative& alternative, const Interval& threshold,
                              const Box& box, const RealPoint& point);

/// threshold - mass in kg
Linearization mass_form(const Alternative& alternative, const Interval& threshold, const Box& box,
                        const RealPoint& point);

}  // namespace torquewright::gearbox::proof
