// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/gearbox/drawn_gearbox.hpp"

namespace torquewright::report {

/// A complete SVG document on an A3 sheet: the layers side by side, to scale, with true tooth
/// flanks assembled in mesh (docs/derivations/tooth_outline.md and assembly_phase.md), dimensions,
/// gear data and a title block. No profile shift, no backlash. The same input gives the same bytes.
/// Gears of fewer than 7 or more than 600 teeth are drawn as their tip and root circles. Throws
/// std::invalid_argument if the topology is unknown, a count is not positive or does not belong to
/// it, or a number is outside the range that its message states.
std::string gearbox_drawing(const DrawnGearbox& drawing);

}  // namespace torquewright::report
