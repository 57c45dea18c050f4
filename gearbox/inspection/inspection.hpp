// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox {

/// What a workshop measures of teeth without backlash; lengths in modules. Formulas: SDP/SI,
/// Elements of Metric Gear Technology (D785), section 10; ISO 21771.
struct SpanMeasure {
  std::int64_t teeth = 0;  ///< Between the jaws.
  double length = 0.0;     ///< W_k = cos(alpha) (pi (k - 1/2) + z inv(alpha)) + 2 x sin(alpha).
};

/// Over as many teeth as bring the jaws nearest to the circle of z + 2 x; nothing for a ring, and
/// where no number of teeth lets both jaws touch involutes.
std::optional<SpanMeasure> span_measure(const ToothForm& form);

/// Over two pins in opposite spaces; in a ring, between them.
struct PinMeasure {
  double pin_diameter = 0.0;
  double length = 0.0;
};

/// The pin diameter that touches both flanks on the circle of z + 2 x, and the measure with it.
/// Nothing where no pin touches there.
std::optional<PinMeasure> best_pin(const ToothForm& form);

/// The measure with a pin of this diameter: inv(phi) = d_p/(z cos(alpha)) - half the space at the
/// base circle outside, the other way round in a ring; z cos(alpha)/cos(phi) +- d_p, for odd teeth
/// times cos(pi/(2 z)). Nothing where the pin is too small to touch.
std::optional<double> over_pins(const ToothForm& form, double pin_diameter);

}  // namespace torquewright::gearbox
