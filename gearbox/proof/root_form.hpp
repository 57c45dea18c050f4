// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/alternative.hpp"

namespace torquewright::gearbox::proof {

/// Depth below its middle line, in modules, to which the hob is straight: 1 where the problem does
/// not state it.
Interval straight_depth(const Problem& problem);

/// A hob of that depth does not undercut.
bool is_not_undercut(const Problem& problem, std::int64_t teeth);

/// The planet's involute reaches down to where the ring's tip touches it. Grows with the ring.
bool has_root_form_of_hob(const Problem& problem, std::int64_t ring);

/// The ring's involute reaches out to where the planet's tip touches it. Requires stated teeth of
/// the shaper.
bool has_root_form_of_shaper(const Problem& problem, std::int64_t planet, std::int64_t ring);

}  // namespace torquewright::gearbox::proof
