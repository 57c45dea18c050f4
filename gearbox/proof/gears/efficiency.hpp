// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"
#include "gearbox/proof/gears/rough_interval.hpp"

namespace torquewright::gearbox::proof {

/// Weighted loss integral 2 int |x|/k(x) dx along a path of contact with parts e_A and e_R beyond
/// the pitch point, k the number of meshing pairs; path shorter than 3 base pitches. `Number` here
/// and below is Interval or RoughInterval.
template <typename Number>
Number loss_integral(const Number& approach, const Number& recess);

/// Forward and backward efficiency of every design of the box, which holds some, whose ratio lies
/// in `ratio`; backward 0 if self-locking. An enclosure; at a point it is as narrow as the
/// precision.
template <typename Number>
Number forward_efficiency(const Alternative& alternative, const Box& box, const Number& ratio);
template <typename Number>
Number backward_efficiency(const Alternative& alternative, const Box& box, const Number& ratio);

}  // namespace torquewright::gearbox::proof
