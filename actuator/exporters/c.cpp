// SPDX-License-Identifier: Apache-2.0
// A C99 header, and C++, that needs no library: the region as in actuator/clip.hpp, its rows and
// index written out, and its grid over voltage and temperature. N m, rad/s, V, K, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/region_text.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/exporters/text.hpp"
#include "actuator/mor/clip_table.hpp"
#include "actuator/source_text/c_source.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr double kBeyondAnySpeed_rad_s = 1e300;  // C99 has no literal for infinity

ClipPoints points_of(std::span<const double> shape) {
  const std::size_t rows = shape.size() / 3;
  const auto block = [&](std::size_t i) {
    const auto part = shape.subspan(i * rows, rows);
    return std::vector<double>(part.begin(), part.end());
  };
  return {block(0), block(1), block(2)};
}

std::string rows_text(const TableView& table) {
  std::string text;
  for (std::size_t i = 0; i < table.rows; ++i) {
    const torquewright_row& row = table.row[i];
    const bool is_last = i + 1 == table.rows;
    text += fmt::format("    {{{}, {}, {}, {},\n     {}, {}}},\n", row.speed_rad_s,
                        is_last ? kBeyondAnySpeed_rad_s : row.next_speed_rad_s, row.least_Nm,
                        row.least_slope_Nm_s_rad, row.greatest_Nm, row.greatest_slope_Nm_s_rad);
  }
  return text;
}

std::string index_text(const TableView& table) {
  constexpr std::size_t kPerLine = 20;
  std::string text;
  for (std::size_t i = 0; i <= table.cells; ++i) {
    text += i % kPerLine == 0 ? "    " : " ";
    text += fmt::format("{},", table.first_row[i]);
    if (i % kPerLine == kPerLine - 1 || i == table.cells) text += "\n";
  }
  return text;
}

std::string flat(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) text += number_lines(row, "    ", true);
  return text;
}

std::string array_text(const std::string& name, std::string_view what, const std::string& values) {
  return fmt::format("static const double {}_{}[] = {{\n{}}};\n", name, what, values);
}

std::string bound_arrays(const std::string& name, const GridBound& bound) {
  return array_text(name, "corner_rad_s", flat(bound.corners_rad_s)) +
         array_text(name, "place", number_lines(bound.places, "    ", true)) +
         array_text(name, "torque_Nm", flat(bound.torques_Nm));
}

std::string bound_fields(const std::string& name, const GridBound& bound) {
  return fmt::format("{{{1}, {2}, {3}, {0}_corner_rad_s, {0}_place, {0}_torque_Nm}}", name,
                     bound.corners_rad_s.front().size(), bound.places.size(), rest_place(bound));
}

std::string grid_arrays(const std::string& name, const RegionGrid& grid) {
  return array_text(name, "voltage_V", number_lines(grid.voltages_V, "    ", false)) +
         array_text(name, "temperature_K", number_lines(grid.temperatures_K, "    ", false)) +
         bound_arrays(name + "_least", grid.least) +
         bound_arrays(name + "_greatest", grid.greatest);
}

std::string grid_fields(const std::string& name, const std::optional<RegionGrid>& grid) {
  if (!grid) return "0, 0, NULL, NULL, {0, 0, 0, NULL, NULL, NULL}, {0, 0, 0, NULL, NULL, NULL}";
  return fmt::format("{1}, {2}, {0}_voltage_V, {0}_temperature_K,\n    {3},\n    {4}", name,
                     grid->voltages_V.size(), grid->temperatures_K.size(),
                     bound_fields(name + "_least", grid->least),
                     bound_fields(name + "_greatest", grid->greatest));
}

std::string armature_line(const std::string& name, double armature_kg_m2) {
  if (armature_kg_m2 == 0.0) return "";
  return fmt::format("static const double {}_armature_kg_m2 = {};\n", name, armature_kg_m2);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const std::string name = identifier(subject.actuator.name);
  const std::optional<RegionGrid> grid = exported_grid(subject);
  const ClipTable table(points_of(shape));
  const TableView view = table.view();
  return line_comment(note, "// ") + line_comment(grid_lines(grid), "// ") +
         fmt::format("#ifndef TORQUEWRIGHT_REGION_OF_{0}\n#define TORQUEWRIGHT_REGION_OF_{0}\n\n",
                     name) +
         std::string(kCSource) +
         fmt::format(R"(
static const torquewright_region_row {0}_row[] = {{
{1}}};
static const unsigned short {0}_first_row[] = {{
{2}}};
{3}{4}
static const torquewright_region {0} = {{
    {5}, {6}, {7},
    {0}_row, {8}, {{{9}, {10}}}, {0}_first_row, {11}, {12},
    {13}}};

/* The torque [Nm] that the actuator can have at a velocity [rad/s]. */
static inline double {0}_clip(double torque_Nm, double velocity_rad_s) {{
  return torquewright_region_clip(&{0}, torque_Nm, velocity_rad_s);
}}

/* The same at a supply voltage without load [V] and a winding temperature [K]. */
static inline double {0}_clip_under(double torque_Nm, double velocity_rad_s, double voltage_V,
                                    double temperature_K) {{
  return torquewright_region_clip_under(&{0}, torque_Nm, velocity_rad_s, voltage_V, temperature_K);
}}

#endif
)",
                     name, rows_text(view), index_text(view), grid ? grid_arrays(name, *grid) : "",
                     armature_line(name, subject.armature_kg_m2()),
                     greatest_torque_Nm(subject, grid), subject.bus_voltage_V(),
                     winding_temperature_K(subject.actuator, subject.conditions), view.rows,
                     view.rest.least_Nm, view.rest.greatest_Nm, view.cells, view.cells_per_rad_s,
                     grid_fields(name, grid));
}

}  // namespace

const Exporter c = {
    .name = "c",
    .simulator = "C99 or C++, a header without dependencies",
    .source = "ISO/IEC 9899:1999; docs/simulator_formats.md",
    .advice =
        "The region itself: NAME_clip(torque_Nm, velocity_rad_s), or NAME_clip_under with a supply "
        "voltage and a winding temperature; torquewright_region_clip_all for arrays. A command is "
        "the torque on the load: what friction takes is in the limits, not subtracted besides.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
