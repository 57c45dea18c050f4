// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/drawing_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/report/gearbox/drawing_dimensions.hpp"
#include "src/report/gearbox/gear_path.hpp"

namespace torquewright::report {
namespace {

using gearbox::PlanetPhase;

/// The x axis of the gearbox points up on the sheet.
constexpr double kUp_rad = 0.5 * std::numbers::pi;
constexpr double kLabelRoom_mm = 10.5;  // Radius inside which a label of a gear finds room.

struct View {
  const DrawingLayout& layout;
  const DrawnLayer& layer;
  Point center;

  double paper_mm(double length_mm) const { return length_mm * layout.scale; }
  double paper_of_modules(double modules) const {
    return paper_mm(modules * planet().module_mm);  // Both layers meet in the sun's only.
  }
  const DrawnGear& sun() const { return layout.gears.front(); }
  const DrawnGear& planet() const { return layout.gears[layer.planet]; }
  /// Requires a layer that has one.
  const DrawnGear& ring() const { return layout.gears[layer.ring.value()]; }
  double blank_mm() const { return 0.5 * paper_mm(outer_diameter_mm(layout, layer)); }
  double bore_mm() const { return 0.5 * paper_mm(layout.drawing.hollow_shaft_diameter_mm); }
  bool has_bore() const { return bore_mm() > 0.0 && !layer.is_second; }
  Point planet_center(const PlanetPhase& planet_phase) const {
    return on_circle(center, paper_mm(layout.center_distance_mm),
                     planet_phase.position_rad + kUp_rad);
  }
  double planet_rad(const PlanetPhase& planet_phase) const {
    return layer.is_second ? planet_phase.planet_2_rad : planet_phase.planet_1_rad;
  }
};

double pitch_radius(const DrawnGear& gear) { return 0.5 * static_cast<double>(gear.teeth); }

std::string two_decimals(double value) { return fmt::format("{:.2f}", value); }

std::string placed(const std::string& id, std::string_view style, const Point& place,
                   double phase_rad) {
  return fmt::format("<use class=\"{}\" href=\"#{}\" transform=\"translate({} {}) rotate({})\"/>\n",
                     style, id, decimal(place.x, 6), decimal(place.y, 6),
                     decimal(-(phase_rad + kUp_rad) * 180.0 / std::numbers::pi, 9));
}

std::string gears(const View& view) {
  const double ring_rad =
      view.layer.is_second ? view.layout.phase.output_ring_rad : view.layout.phase.fixed_ring_rad;
  std::string svg;
  if (view.layer.ring) svg += placed(view.ring().id, view.ring().id, view.center, ring_rad);
  const std::string sun_style = view.layer.is_second ? "hidden" : "sun";
  svg += placed("sun", sun_style, view.center, view.layout.phase.sun_rad);
  for (const PlanetPhase& planet : view.layout.phase.planets) {
    svg += placed(view.planet().id, view.planet().id, view.planet_center(planet),
                  view.planet_rad(planet));
  }
  if (view.has_bore()) svg += svg_circle("bore", view.center, view.bore_mm());
  return svg;
}

std::string cross(const Point& center, double half_length_mm, double direction_rad) {
  std::string svg;
  for (const double turn_rad : {0.0, 0.5 * std::numbers::pi}) {
    svg += svg_line("center", on_circle(center, -half_length_mm, direction_rad + turn_rad),
                    on_circle(center, half_length_mm, direction_rad + turn_rad));
  }
  return svg;
}

std::string center_lines(const View& view) {
  std::string svg = cross(view.center, view.blank_mm() + 4.0, 0.0);
  if (view.layer.ring) {
    svg += svg_circle("center", view.center, view.paper_of_modules(pitch_radius(view.ring())));
  }
  svg += svg_circle("center", view.center, view.paper_mm(view.layout.center_distance_mm));
  if (!view.layer.is_second) {
    svg += svg_circle("center", view.center, view.paper_of_modules(pitch_radius(view.sun())));
  }
  const double reach_mm = view.paper_of_modules(view.planet().tip_radius) + 2.0;
  for (const PlanetPhase& planet : view.layout.phase.planets) {
    const Point center = view.planet_center(planet);
    svg += svg_circle("center", center, view.paper_of_modules(pitch_radius(view.planet())));
    svg += cross(center, reach_mm, planet.position_rad + kUp_rad);
  }
  return svg;
}

// A dot under the tooth that is set to the other layer's marked tooth of the same planet.
std::string clocking_marks(const View& view) {
  std::string svg;
  const double radius_mm = view.paper_of_modules(std::max(0.0, view.planet().root_radius - 0.8));
  for (const PlanetPhase& planet : view.layout.phase.planets) {
    const Point place =
        on_circle(view.planet_center(planet), radius_mm, view.planet_rad(planet) + kUp_rad);
    svg += svg_circle("mark", place, std::min(0.6, 0.4 * view.paper_of_modules(1.0)));
  }
  return svg;
}

std::string planet_labels(const View& view) {
  const double room_mm = view.paper_of_modules(view.planet().root_radius);
  if (room_mm < 0.5 * kLabelRoom_mm) return "";
  const std::string label = room_mm < kLabelRoom_mm
                                ? view.planet().symbol
                                : fmt::format("{}: {}", view.planet().symbol, view.planet().teeth);
  std::string svg;
  for (const PlanetPhase& planet : view.layout.phase.planets) {
    const Point center = view.planet_center(planet);
    svg += svg_text("label middle", {center.x, center.y - 2.2}, label);
    if (view.layout.phase.planet_types > 1) {
      svg += svg_text("note middle", {center.x, center.y + 4.8},
                      fmt::format("part {}", planet.part_number));
    }
  }
  return svg;
}

// The direction at the lower left that stays farthest from the middles of all planets.
double free_direction_rad(const View& view) {
  double best_rad = 0.0;
  double best_cosine = 2.0;
  for (int degrees = 200; degrees <= 245; ++degrees) {
    const double direction_rad = degrees * std::numbers::pi / 180.0;
    double cosine = -1.0;
    for (const PlanetPhase& planet : view.layout.phase.planets) {
      cosine = std::max(cosine, std::cos(direction_rad - planet.position_rad - kUp_rad));
    }
    if (cosine < best_cosine - 1e-9) {
      best_cosine = cosine;
      best_rad = direction_rad;
    }
  }
  return best_rad;
}

std::string bore_dimension(const View& view) {
  const std::string text = "\xC3\x98 " + two_decimals(view.layout.drawing.hollow_shaft_diameter_mm);
  if (view.bore_mm() > 12.0) return diameter_inside(view.center, view.bore_mm(), text);
  const double free_rad = free_direction_rad(view);
  return leader(on_circle(view.center, view.bore_mm(), free_rad),
                on_circle(view.center, view.blank_mm() + 6.0, free_rad), text + " bore");
}

std::string sun_label(const View& view) {
  const double room_mm =
      view.has_bore() ? view.bore_mm() : view.paper_of_modules(view.sun().root_radius);
  if (view.layer.is_second || room_mm < kLabelRoom_mm) return "";
  const double height_mm = view.has_bore() && room_mm > 12.0 ? 0.45 * room_mm : 2.2;
  return svg_text("label middle", {view.center.x, view.center.y - height_mm},
                  fmt::format("S: {}", view.sun().teeth));
}

std::string ring_label(const View& view) {
  if (!view.layer.ring) return "";
  constexpr double kDirection_rad = 52.0 * std::numbers::pi / 180.0;
  const double wall_mm = view.paper_mm(ring_wall_mm(view.layout, view.ring()));
  return leader(on_circle(view.center, view.blank_mm() - 0.5 * wall_mm, kDirection_rad),
                on_circle(view.center, view.blank_mm() + 9.0, kDirection_rad),
                fmt::format("{}: {} teeth", view.ring().symbol, view.ring().teeth));
}

// The gap between the pitch circles of the first two planets, seen from the sun's axis.
std::string clearance_dimension(const View& view) {
  const auto& planets = view.layout.phase.planets;
  if (planets.size() < 2 || view.layer.is_second) return "";
  const double half_planet_rad =
      std::numbers::pi / static_cast<double>(planets.size()) - view.layout.carrier_clearance_rad;
  const double from_rad = kUp_rad + planets[0].position_rad + half_planet_rad;
  const double to_rad = kUp_rad + planets[1].position_rad - half_planet_rad;
  if (to_rad <= from_rad) return "";
  return angular_dimension(
      view.center, view.paper_of_modules(view.sun().tip_radius), view.blank_mm(), from_rad, to_rad,
      fmt::format("\xCE\xB1 = {}\xC2\xB0",
                  two_decimals((to_rad - from_rad) * 180.0 / std::numbers::pi)));
}

std::string pitch_dimension(const View& view) {
  const Point& c = view.center;
  const double pitch_mm = view.paper_of_modules(pitch_radius(view.ring()));
  return horizontal_dimension(
      c.x - pitch_mm, c.x + pitch_mm, c.y, c.y + view.blank_mm() + 7.0,
      "pitch \xC3\x98 " +
          two_decimals(static_cast<double>(view.ring().teeth) * view.ring().module_mm));
}

std::string dimensions(const View& view) {
  const Point& c = view.center;
  const double blank_mm = view.blank_mm();
  std::string svg = view.layer.ring ? pitch_dimension(view) : "";
  svg += horizontal_dimension(c.x - blank_mm, c.x + blank_mm, c.y, c.y + blank_mm + 13.5,
                              (view.layer.ring ? "blank \xC3\x98 " : "tips \xC3\x98 ") +
                                  two_decimals(outer_diameter_mm(view.layout, view.layer)));
  const double distance_mm = view.paper_mm(view.layout.center_distance_mm);
  const double reach_mm = view.paper_of_modules(view.planet().tip_radius) + 3.0;
  svg += vertical_dimension({c.x + blank_mm + 5.0, c.y}, {c.x + reach_mm, c.y - distance_mm},
                            c.x + blank_mm + 8.0,
                            fmt::format("a = {}", decimal(view.layout.center_distance_mm, 6)));
  if (view.has_bore()) svg += bore_dimension(view);
  return svg + clearance_dimension(view);
}

}  // namespace

std::string shape_definitions(const DrawingLayout& layout) {
  std::string svg = "<defs>\n";
  for (const DrawnGear& gear : layout.gears) {
    const double paper_mm_per_module = layout.scale * gear.module_mm;
    std::string path = gear.form ? gear_path(*gear.form, paper_mm_per_module)
                                 : circle_path(gear.tip_radius * paper_mm_per_module) +
                                       circle_path(gear.root_radius * paper_mm_per_module);
    if (gear.internal) path += circle_path(0.5 * layout.scale * blank_diameter_mm(layout, gear));
    svg += fmt::format("<path id=\"{}\" d=\"{}\"/>\n", gear.id, path);
  }
  return svg + "</defs>\n";
}

std::string layer_view(const DrawingLayout& layout, const DrawnLayer& layer, const Point& center) {
  const View view{layout, layer, center};
  return svg_text("heading middle", {center.x, 15.0}, layer.title) + gears(view) +
         center_lines(view) + clocking_marks(view) + dimensions(view) + planet_labels(view) +
         sun_label(view) + ring_label(view);
}

}  // namespace torquewright::report
