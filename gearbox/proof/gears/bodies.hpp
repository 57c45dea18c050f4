// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"

namespace torquewright::gearbox::proof {

/// Mass in kg and inertia about the own axis in kg m^2.
struct Body {
  Interval mass_kg, inertia_kg_m2;
};

/// Discs and annuli of docs/gearbox_constraints.md.
Body sun_body(const Alternative& alternative, std::int64_t teeth);
Body planet_disc(const Alternative& alternative, std::int64_t teeth, int layer);
Body ring_body(const Alternative& alternative, std::int64_t teeth, int layer);

/// An interval that holds the mass of every design in the range. It is tight, for each body's mass
/// grows with its teeth.
Interval total_mass_kg(const Alternative& alternative, const TeethRange& range);

/// An interval that holds the inertia at the output of every design in the range whose ratio lies
/// in `ratio`.
Interval reflected_inertia_kg_m2(const Alternative& alternative, const TeethRange& range,
                                 const Interval& ratio);

}  // namespace torquewright::gearbox::proof
