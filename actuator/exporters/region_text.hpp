// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/conditions/region_grid.hpp"
#include "actuator/conditions/winding_line.hpp"
#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// The region of the subject over voltage and temperature; conservative: both bounds drawn in by
/// the error up to RegionGrid::kBeforeEnd of the speeds. Nothing where it has a gap.
std::optional<RegionGrid> exported_grid(const Subject& subject);

/// The same, and the winding's line where the region is one, exactly: before anything is drawn in.
struct ExportedConditions {
  std::optional<RegionGrid> grid;
  std::optional<WindingLine> line;
};
ExportedConditions exported_conditions(const Subject& subject);

/// What a file says of its grid, or why it has none: a line each.
std::vector<std::string> grid_lines(const std::optional<RegionGrid>& grid);

/// Greatest magnitude of a bound, in the table and in the grid.
double greatest_torque_Nm(const Subject& subject, const std::optional<RegionGrid>& grid);

/// The number of the place at rest from below; the next is from above.
std::size_t rest_place(const GridBound& bound);

/// Numbers behind commas, the lines indented: all digits, four a line, or ten digits, eight a line.
std::string number_lines(std::span<const double> values, std::string_view indent, bool is_rounded);

}  // namespace torquewright::actuator
