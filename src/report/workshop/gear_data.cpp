// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/gear_data.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::report {
namespace {

void add_measures(const DrawnGear& gear, GearData& data) {
  if (!gear.form) return;
  data.cutter_tip_radius = gear.form->fillet_radius;
  const double module_mm = gear.module_mm;
  if (const auto span = gearbox::span_measure(*gear.form)) {
    data.span_teeth = span->teeth;
    data.span_mm = span->length * module_mm;
  }
  const auto best = gearbox::best_pin(*gear.form);
  if (!best) return;
  const double steps_per_mm = module_mm < 0.5 ? 100.0 : 10.0;
  const double pin_mm = std::round(best->pin_diameter * module_mm * steps_per_mm) / steps_per_mm;
  const auto over = gearbox::over_pins(*gear.form, pin_mm / module_mm);
  if (!over) return;
  data.pin_diameter_mm = pin_mm;
  data.over_pins_mm = *over * module_mm;
}

}  // namespace

std::vector<GearData> gear_data(const DrawingLayout& layout,
                                const std::vector<double>& face_width_mm) {
  std::vector<GearData> list;
  for (const DrawnGear& gear : layout.gears) {
    GearData data;
    const auto teeth = static_cast<double>(gear.teeth);
    data.gear = gear.id;
    data.number = gear.symbol.front() == 'P' ? layout.drawing.planet_count : 1;
    data.teeth = gear.teeth;
    data.module_mm = gear.module_mm;
    data.profile_shift = gear.shift;
    data.pitch_diameter_mm = gear.module_mm * teeth;
    data.tip_diameter_mm = 2.0 * gear.module_mm * gear.tip_radius;
    data.root_diameter_mm = 2.0 * gear.module_mm * gear.root_radius;
    data.base_diameter_mm = data.pitch_diameter_mm * std::cos(gearbox::kPressureAngle_rad);
    const std::size_t layer = gear.layer == "1" ? 0 : 1;
    if (layer < face_width_mm.size()) data.face_width_mm = face_width_mm[layer];
    add_measures(gear, data);
    list.push_back(std::move(data));
  }
  return list;
}

std::vector<std::pair<std::string, std::string>> data_lines(const GearData& data) {
  const bool is_ring = data.root_diameter_mm > data.tip_diameter_mm;
  const auto mm = [](double value) { return fmt::format("{:.4f} mm", value); };
  std::vector<std::pair<std::string, std::string>> lines{
      {"number", std::to_string(data.number)},
      {"teeth", std::to_string(data.teeth)},
      {"module", fmt::format("{:g} mm", data.module_mm)},
      {"pressure angle", "20 deg"},
      {"profile shift", fmt::format("{:.6f} module", data.profile_shift)},
      {"tip diameter", mm(data.tip_diameter_mm)},
      {"pitch diameter", mm(data.pitch_diameter_mm)},
      {"base diameter", mm(data.base_diameter_mm)},
      {"root diameter", mm(data.root_diameter_mm)}};
  if (data.face_width_mm) lines.emplace_back("face width", mm(*data.face_width_mm));
  if (data.span_mm) {
    lines.emplace_back(fmt::format("span over {} teeth", *data.span_teeth), mm(*data.span_mm));
  }
  if (data.over_pins_mm) {
    lines.emplace_back(
        fmt::format("{} pins of {:g} mm", is_ring ? "between" : "over", *data.pin_diameter_mm),
        mm(*data.over_pins_mm));
  }
  lines.emplace_back("tip radius of the cutter",
                     fmt::format("{:.4f} module", data.cutter_tip_radius));
  return lines;
}

}  // namespace torquewright::report
