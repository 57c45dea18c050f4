// SPDX-License-Identifier: Apache-2.0
// One Python module that needs nothing but the array library of whoever calls it: the region itself
// as tables. What it calls is in the array API standard (data-apis.org/array-api, 2024.12: asarray,
// searchsorted, where, clip, minimum, maximum, indexing by arrays of integers) and in PyTorch 1.13
// and NumPy 1.24 alike. N m, rad/s, V, K, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/python_source.hpp"
#include "actuator/exporters/region_text.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string rows_text(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) {
    text += fmt::format("                [\n{}                ],\n",
                        number_lines(row, "                    ", true));
  }
  return text;
}

std::string bound_text(std::string_view name, const GridBound& bound) {
  return fmt::format(R"(        "{0}": {{
            "rest_place": {1},
            "place": [
{2}            ],
            "corner_rad_s": [
{3}            ],
            "torque_Nm": [
{4}            ],
        }},
)",
                     name, rest_place(bound), number_lines(bound.places, "                ", true),
                     rows_text(bound.corners_rad_s), rows_text(bound.torques_Nm));
}

/// The grid, a condition after the other, temperatures within voltages.
std::string grid_text(const std::optional<RegionGrid>& grid) {
  if (!grid) return "None";
  return fmt::format(R"({{
        "voltage_V": [
{0}        ],
        "temperature_K": [
{1}        ],
{2}{3}    }})",
                     number_lines(grid->voltages_V, "            ", false),
                     number_lines(grid->temperatures_K, "            ", false),
                     bound_text("least", grid->least), bound_text("greatest", grid->greatest));
}

std::string armature_text(double armature_kg_m2) {
  return armature_kg_m2 > 0.0 ? fmt::format("{}", armature_kg_m2) : "None";
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const std::optional<RegionGrid> grid = exported_grid(subject);
  const std::size_t rows = shape.size() / 3;
  const TorqueLimits rest = table_law(shape, 0.0);
  const auto block = [&](std::size_t i) {
    return number_lines(shape.subspan(i * rows, rows), "            ", false);
  };
  return line_comment(note, "# ") + line_comment(grid_lines(grid), "# ") +
         std::string(kPythonSource) +
         fmt::format(R"(
REGION = Region(
    name="{0}",
    peak_torque_Nm={1},
    armature_kg_m2={2},
    voltage_V={3},
    temperature_K={4},
    table={{
        "speed_rad_s": [
{5}        ],
        "least_Nm": [
{6}        ],
        "greatest_Nm": [
{7}        ],
        "rest_Nm": [{8}, {9}],
    }},
    grid={10},
)

clip = REGION.clip
limits = REGION.limits
)",
                     identifier(subject.actuator.name), greatest_torque_Nm(subject, grid),
                     armature_text(subject.armature_kg_m2()), subject.bus_voltage_V(),
                     winding_temperature_K(subject.actuator, subject.conditions), block(0),
                     block(1), block(2), rest.least_Nm, rest.greatest_Nm, grid_text(grid));
}

}  // namespace

const Exporter python = {
    .name = "python",
    .simulator = "Python, a module for NumPy, PyTorch and JAX (Isaac Lab, mjlab)",
    .source =
        "https://data-apis.org/array-api; IsaacLab actuators/actuator_pd.py @ eafe554d; mjlab "
        "actuator/pd_actuator.py @ 6624f2b0",
    .advice =
        "The region itself: clip(torque, velocity, voltage, temperature) of arrays. Isaac Lab: "
        "REGION.isaac_lab(joint_names_expr=[...], stiffness=..., damping=...); mjlab: "
        "REGION.mjlab(target_names_expr=(...), stiffness=..., damping=...). A command is the "
        "torque on the load: what friction takes is in the limits, not subtracted besides.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
