// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"
#include "gearbox/proof/gears/rough_interval.hpp"

namespace torquewright::gearbox::proof {

/// The two parts of a path of contact, in base pitches: beyond the pitch point at the tip of the
/// gear with external teeth that comes first, and at the tip of its mate.
template <typename Number>
struct ContactPath {
  Number first, mate;
};

/// An enclosure of the path of contact of every design in the range. Mesh 0: sun and planet 1; 1:
/// planet 1 and its ring; 2: planet 2 and its ring.
template <typename Number>
ContactPath<Number> contact_path(const TeethRange& range, int mesh);

/// An enclosure of the contact ratio, the sum of both parts of that path, of every design in the
/// range.
Interval contact_ratio(const TeethRange& range, int mesh);

}  // namespace torquewright::gearbox::proof
