// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/inspection/inspection.hpp"
#include "src/report/gearbox/drawing_layout.hpp"

namespace torquewright::report {

/// What a workshop needs to know of one gear beside its outline; lengths in mm.
struct GearData {
  std::string gear;  ///< As in documents: sun, planet_1, ...
  std::int64_t number = 1;
  std::int64_t teeth = 0;
  double module_mm = 0.0;
  double profile_shift = 0.0;
  double pitch_diameter_mm = 0.0;
  double tip_diameter_mm = 0.0;
  double root_diameter_mm = 0.0;
  double base_diameter_mm = 0.0;
  std::optional<double> face_width_mm;
  std::optional<std::int64_t> span_teeth;
  std::optional<double> span_mm;  ///< Over them, without backlash.
  std::optional<double> pin_diameter_mm;
  std::optional<double> over_pins_mm;  ///< Over two; in a ring between them.
  double cutter_tip_radius = 0.0;      ///< In modules.
};

/// Of every gear of a drawing, in its order. Pins are whole tenths of a millimetre, hundredths
/// below a module of 0.5 mm.
std::vector<GearData> gear_data(const DrawingLayout& layout,
                                const std::vector<double>& face_width_mm);

/// The same as lines of a table: what, and its value.
std::vector<std::pair<std::string, std::string>> data_lines(const GearData& data);

}  // namespace torquewright::report
