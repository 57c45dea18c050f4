// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/relaxation/linearization.hpp"

namespace torquewright::gearbox::proof {

/// h_c of docs/certificate.md, linearised at `point`, which lies in the box; empty where the
/// condition has no concave form there.
std::optional<Linearization> linearize(const Claim& claim, const Alternative& alternative,
                                       const Condition& condition, const Box& box,
                                       const RealPoint& point);

}  // namespace torquewright::gearbox::proof
