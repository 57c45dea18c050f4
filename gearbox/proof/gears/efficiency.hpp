// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"

namespace torquewright::gearbox::proof {

/// Weighted loss integral 2 int |x|/k(x) dx along a path of contact with parts e_A and e_R beyond
/// the pitch point, k the number of meshing pairs; path shorter than 3 base pitches.
Interval loss_integral(const Interval& approach, const Interval& recess);

/// Forward and backward efficiency of every design of the box, which holds some, whose ratio lies
/// in `ratio`; backward 0 if self-locking. An enclosure; at a point it is as narrow as the
/// precision.
Interval forward_efficiency(const Alternative& alternative, const Box& box, const Interval& ratio);
Interval backward_efficiency(const Alternative& alternative, const Box& box, const Interval& ratio);

}  // namespace torquewright::gearbox::proof
