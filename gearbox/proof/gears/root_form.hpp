// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"

namespace torquewright::gearbox::proof {

/// Depth below its middle line, in modules, that decides on undercut: to which the stated hob is
/// straight, else one of 0.38, and a rack's addendum of 1 at least.
Interval undercut_depth(const Problem& problem);

/// A hob of that depth does not undercut.
bool is_not_undercut(const Problem& problem, std::int64_t teeth);

/// The planet's involute reaches down to where the ring's tip touches it. Grows with the ring.
bool has_root_form_of_hob(const Problem& problem, std::int64_t ring);

/// The involutes of sun and planet reach down to where the mate's tip touches them. Falls with
/// both. Requires a stated tip radius.
bool has_root_form_of_hob(const Problem& problem, std::int64_t sun, std::int64_t planet);

/// The ring's involute reaches out to where the planet's tip touches it. A shaper whose
/// teeth are not stated has those of the planet. Falls with the planet, grows with the ring.
bool has_root_form_of_shaper(const Problem& problem, std::int64_t planet, std::int64_t ring);

}  // namespace torquewright::gearbox::proof
