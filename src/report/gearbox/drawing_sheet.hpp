// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/gearbox/drawing_layout.hpp"

namespace torquewright::report {

/// The sheet [mm] is as high as A3, with as wide a column for each view: two are A3 (ISO 216),
/// three A4 x 3 (ISO 5457).
inline constexpr double kColumnWidth_mm = 210.0;
inline constexpr double kSheetHeight_mm = 297.0;

/// Of the views of all layers and the section.
double sheet_width_mm(const DrawingLayout& layout);

/// Where the gear table and the title block begin.
inline constexpr double kTableTop_mm = 231.0;

/// White paper, frame and the styles of all elements.
std::string sheet_opening(const DrawingLayout& layout);

/// Colours, lines and marks in one line.
std::string legend(const DrawingLayout& layout);

/// One row per gear.
std::string gear_table(const DrawingLayout& layout);

/// Name, ratio, module, planets and their part numbers, scale, scale bar, remarks.
std::string title_block(const DrawingLayout& layout);

}  // namespace torquewright::report
