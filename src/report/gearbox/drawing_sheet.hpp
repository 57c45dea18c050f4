// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/gearbox/drawing_layout.hpp"

namespace torquewright::report {

/// The A3 sheet [mm].
inline constexpr double kSheetWidth_mm = 420.0;
inline constexpr double kSheetHeight_mm = 297.0;

/// Where the gear table and the title block begin.
inline constexpr double kTableTop_mm = 231.0;

/// White paper, frame and the styles of all elements.
std::string sheet_opening();

/// Colours, lines and marks in one line.
std::string legend(const DrawingLayout& layout);

/// One row per gear.
std::string gear_table(const DrawingLayout& layout);

/// Name, ratio, module, planets and their part numbers, scale, scale bar, remarks.
std::string title_block(const DrawingLayout& layout);

}  // namespace torquewright::report
