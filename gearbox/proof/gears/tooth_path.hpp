// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/rough_interval.hpp"

namespace torquewright::gearbox::proof {

/// Pressure angle of the reference profile: 20 degrees, in rad.
const Interval& pressure_angle();

/// An enclosure of the involute function, tan x - x.
Interval involute(const Interval& angle);

/// Whether the tip circle of a ring lies outside its base circle; where not, nothing meshes with
/// it.
bool has_tip_outside_base(std::int64_t ring);

/// Pressure angles at the tip circles of a gear with external teeth (always defined) and of a ring.
/// Where a ring's tip circle lies inside its base circle the flank ends there: 0.
Interval external_tip_angle(std::int64_t teeth);
Interval ring_tip_angle(std::int64_t teeth);

/// Length of the path of contact beyond the pitch point that a gear's tip allows, in base pitches.
/// `Number` is Interval or RoughInterval.
template <typename Number>
Number external_path(std::int64_t teeth);
template <typename Number>
Number ring_path(std::int64_t teeth);

/// An enclosure of that path for all tooth counts of a range, tight: external paths grow with the
/// teeth, (de/dz > 0 because 4/cos^2 alpha > 0), ring paths fall from 34 teeth on and grow up to
/// 33.
template <typename Number>
Number external_path(std::int64_t fewest, std::int64_t most);
template <typename Number>
Number ring_path(std::int64_t fewest, std::int64_t most);

}  // namespace torquewright::gearbox::proof
