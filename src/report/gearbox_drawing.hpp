// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace torquewright::report {

/// What a drawing of a gearbox shows.
struct GearboxDrawing {
  std::string name;
  std::string topology;             ///< "3k" or "planetary".
  std::vector<std::int64_t> teeth;  ///< In the topology's order: S, P1, P2, F, O or S, P, R.
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  std::string ratio;                      ///< As text: "20" or "1067/52".
  double hollow_shaft_diameter_mm = 0.0;  ///< Not drawn unless positive.
  std::optional<double> ring_wall_mm;     ///< Behind the ring's root; default 2.25 module.
};

/// A complete SVG document on an A3 sheet: the layers side by side, to scale, with true tooth
/// flanks assembled in mesh (docs/derivations/tooth_outline.md and assembly_phase.md), dimensions,
/// gear data and a title block. No profile shift, no backlash. The same input gives the same bytes.
/// Gears of fewer than 7 or more than 600 teeth are drawn as their tip and root circles. Throws
/// std::invalid_argument if the topology is unknown, a count is not positive or does not belong to
/// it, or a number is outside the range that its message states.
std::string gearbox_drawing(const GearboxDrawing& drawing);

}  // namespace torquewright::report
