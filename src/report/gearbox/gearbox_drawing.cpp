// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/gearbox_drawing.hpp"

#include "src/report/gearbox/drawing_layout.hpp"
#include "src/report/gearbox/drawing_section.hpp"
#include "src/report/gearbox/drawing_sheet.hpp"
#include "src/report/gearbox/drawing_view.hpp"

namespace torquewright::report {

std::string gearbox_drawing(const DrawnGearbox& drawing) {
  constexpr double kViewY_mm = 108.0;
  const DrawingLayout layout = lay_out(drawing);
  std::string svg = sheet_opening(layout) + shape_definitions(layout);
  double x_mm = 0.5 * kColumnWidth_mm;
  for (const DrawnLayer& layer : layout.layers) {
    svg += layer_view(layout, layer, {x_mm, kViewY_mm});
    x_mm += kColumnWidth_mm;
  }
  svg += axial_section(layout, {x_mm, kViewY_mm});
  return svg + legend(layout) + gear_table(layout) + title_block(layout) + "</svg>\n";
}

}  // namespace torquewright::report
