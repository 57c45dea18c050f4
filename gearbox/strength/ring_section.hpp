// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "gearbox/strength/strength.hpp"
#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox {

/// Sentence on what is assumed of a ring's root, and on which side.
inline constexpr std::string_view kRingSectionSentence =
    "Assumed: a ring's root is as strong as the worst section of the trochoid that its shaper "
    "leaves, with the beam formula of external teeth; a standard's fixed section would ask for "
    "less.";

/// A section across a ring's tooth from fillet to fillet, loaded at the tip; lengths in modules.
struct RingSection {
  double chord = 0.0;
  double lever = 0.0;
  double fillet_radius = 0.0;
  RootFactors factors;
};

/// The section of the trochoid that the ring's shaper leaves, in which a beam's stress with its
/// notch, Y_F Y_S, is greatest. docs/derivations/strength.md eq. (6). Nothing where no shaper is
/// known or fits.
std::optional<RingSection> critical_ring_section(const ToothForm& ring);

}  // namespace torquewright::gearbox
