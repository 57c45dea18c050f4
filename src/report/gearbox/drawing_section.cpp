// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/drawing_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/report/gearbox/drawing_dimensions.hpp"

namespace torquewright::report {
namespace {

constexpr double kNoteStep_mm = 4.6;

/// A layer's gears between two places along the axis, on paper.
struct Slice {
  const DrawnLayer* layer = nullptr;
  double from_x = 0.0;
  double to_x = 0.0;
};

/// Radii of what is cut, from the axis [mm of the gearbox]: of a body, and of the teeth on it.
struct Radii {
  double inner_mm = 0.0;
  double outer_mm = 0.0;
};

struct Section {
  const DrawingLayout& layout;
  Point center;
  std::vector<Slice> slices;

  double paper_mm(double length_mm) const { return length_mm * layout.scale; }
  const DrawnGear& gear(std::size_t index) const { return layout.gears[index]; }
  double root_mm(const DrawnGear& gear) const { return gear.module_mm * gear.root_radius; }
  double tip_mm(const DrawnGear& gear) const { return gear.module_mm * gear.tip_radius; }

  /// On one side of the axis: up is 1, down -1.
  std::string rectangle(std::string_view style, const Slice& slice, const Radii& radii,
                        double side) const {
    const double near = center.y - side * paper_mm(radii.inner_mm);
    const double far = center.y - side * paper_mm(radii.outer_mm);
    return svg_rectangle(style, {slice.from_x, std::min(near, far)},
                         {slice.to_x - slice.from_x, std::abs(near - far)});
  }
};

Section section_of(const DrawingLayout& layout, const Point& center) {
  Section section{layout, center, {}};
  double x = center.x - 0.5 * section.paper_mm(axial_length_mm(layout));
  for (std::size_t i = 0; i < layout.layers.size(); ++i) {
    const double width = section.paper_mm(layout.face_width_mm[i]);
    section.slices.push_back({&layout.layers[i], x, x + width});
    x += width + section.paper_mm(layout.layer_gap_mm);
  }
  return section;
}

/// A body in its gear's colour, and its teeth, which a cut leaves whole, as an outline.
std::string body_and_teeth(const Section& section, const Slice& slice, const DrawnGear& gear,
                           const Radii& body, const Radii& teeth, double side) {
  return section.rectangle(gear.id, slice, body, side) +
         section.rectangle("frame-thin", slice, teeth, side);
}

std::string ring_part(const Section& section, const Slice& slice, double side) {
  if (!slice.layer->ring) return "";
  const DrawnGear& ring = section.gear(*slice.layer->ring);
  const double root_mm = section.root_mm(ring), tip_mm = section.tip_mm(ring);
  return body_and_teeth(section, slice, ring,
                        {root_mm, 0.5 * blank_diameter_mm(section.layout, ring)}, {tip_mm, root_mm},
                        side);
}

std::string sun_part(const Section& section, const Slice& slice, double side) {
  if (slice.layer->is_second) return "";
  const DrawnGear& sun = section.layout.gears.front();
  const double bore_mm = std::max(0.0, 0.5 * section.layout.drawing.hollow_shaft_diameter_mm);
  return body_and_teeth(section, slice, sun, {bore_mm, section.root_mm(sun)},
                        {section.root_mm(sun), section.tip_mm(sun)}, side);
}

/// The first planet, above the sun, or the one that faces it.
std::string planet_part(const Section& section, const Slice& slice, double side) {
  const DrawnGear& planet = section.gear(slice.layer->planet);
  const double centre_mm = section.layout.center_distance_mm;
  const double root_mm = section.root_mm(planet), tip_mm = section.tip_mm(planet);
  return section.rectangle(planet.id, slice, {centre_mm - root_mm, centre_mm + root_mm}, side) +
         section.rectangle("frame-thin", slice, {centre_mm + root_mm, centre_mm + tip_mm}, side) +
         section.rectangle("frame-thin", slice, {centre_mm - tip_mm, centre_mm - root_mm}, side);
}

/// What joins both gears of a planet: as thick as the thinner one's root, which is assumed.
std::string planet_neck(const Section& section, double side) {
  if (section.slices.size() < 2) return "";
  const Slice gap{nullptr, section.slices[0].to_x, section.slices[1].from_x};
  const double thinner_mm =
      std::min(section.root_mm(section.gear(section.slices[0].layer->planet)),
               section.root_mm(section.gear(section.slices[1].layer->planet)));
  const double centre_mm = section.layout.center_distance_mm;
  return section.rectangle("hidden", gap, {centre_mm - thinner_mm, centre_mm + thinner_mm}, side);
}

std::string center_lines(const Section& section) {
  constexpr double kOver_mm = 6.0;
  const double from_x = section.slices.front().from_x - kOver_mm;
  const double to_x = section.slices.back().to_x + kOver_mm;
  const double planet_y = section.center.y - section.paper_mm(section.layout.center_distance_mm);
  return svg_line("center", {from_x, section.center.y}, {to_x, section.center.y}) +
         svg_line("center", {from_x, planet_y}, {to_x, planet_y});
}

double lowest_y(const Section& section) {
  double blank_mm = 0.0;
  for (const Slice& slice : section.slices) {
    blank_mm = std::max(blank_mm, outer_diameter_mm(section.layout, *slice.layer));
  }
  return section.center.y + 0.5 * section.paper_mm(blank_mm);
}

/// Widths below: each with its leader, since most are too narrow for their words.
std::string dimensions(const Section& section) {
  const double y = lowest_y(section) + 7.0;
  std::string svg;
  for (std::size_t i = 0; i < section.slices.size(); ++i) {
    const Slice& slice = section.slices[i];
    const std::string words =
        fmt::format("b{} = {}{}", i + 1, decimal(section.layout.face_width_mm[i], 3),
                    section.layout.is_width_assumed ? " (assumed)" : "");
    svg += horizontal_dimension(slice.from_x, slice.to_x, y - 5.0, y, "");
    const double outwards = i == 0 && section.slices.size() > 1 ? -1.0 : 1.0;
    const double edge = outwards < 0.0 ? slice.from_x : slice.to_x;
    svg += svg_text(outwards < 0.0 ? "note end" : "note", {edge + outwards * 3.0, y + 1.1}, words);
  }
  return svg;
}

std::string label(const DrawnGear& gear, double x, double y, double outwards) {
  return svg_text(outwards < 0.0 ? "note end" : "note", {x + outwards * 3.0, y + 1.1}, gear.symbol);
}

std::string ring_label(const Section& section, const Slice& slice, double x, double outwards) {
  if (!slice.layer->ring) return "";
  const DrawnGear& ring = section.gear(*slice.layer->ring);
  const double ring_mm =
      0.5 * (section.root_mm(ring) + 0.5 * blank_diameter_mm(section.layout, ring));
  return label(ring, x, section.center.y - section.paper_mm(ring_mm), outwards);
}

std::string labels(const Section& section) {
  std::string svg;
  for (std::size_t i = 0; i < section.slices.size(); ++i) {
    const Slice& slice = section.slices[i];
    const double outwards = i == 0 && section.slices.size() > 1 ? -1.0 : 1.0;
    const double x = outwards < 0.0 ? slice.from_x : slice.to_x;
    svg += ring_label(section, slice, x, outwards);
    svg += label(section.gear(slice.layer->planet), x,
                 section.center.y - section.paper_mm(section.layout.center_distance_mm) - 3.0,
                 outwards);
    if (slice.layer->is_second) continue;
    const DrawnGear& sun = section.layout.gears.front();
    const double bore_mm = std::max(0.0, 0.5 * section.layout.drawing.hollow_shaft_diameter_mm);
    svg +=
        label(sun, x, section.center.y - section.paper_mm(0.5 * (bore_mm + section.root_mm(sun))),
              outwards);
  }
  return svg;
}

std::string notes(const Section& section) {
  std::vector<std::string> lines;
  if (section.layout.is_width_assumed) {
    lines.emplace_back("Face widths are not stated: ten modules are assumed.");
  }
  if (section.slices.size() > 1) {
    lines.push_back(fmt::format("Dashed: {} mm between the layers are assumed.",
                                decimal(section.layout.layer_gap_mm, 3)));
  }
  lines.emplace_back("Not known and not drawn: carrier, pins, bearings.");
  std::string svg;
  double y = lowest_y(section) + 16.0;
  for (const std::string& line : lines) {
    svg += svg_text("note middle", {section.center.x, y}, line);
    y += kNoteStep_mm;
  }
  return svg;
}

}  // namespace

std::string axial_section(const DrawingLayout& layout, const Point& center) {
  const Section section = section_of(layout, center);
  const bool is_faced = layout.drawing.planet_count % 2 == 0;
  std::string svg = svg_text("heading middle", {center.x, 15.0}, "Section along the axis");
  for (const Slice& slice : section.slices) {
    for (const double side : {1.0, -1.0}) {
      svg += ring_part(section, slice, side) + sun_part(section, slice, side);
    }
    svg += planet_part(section, slice, 1.0);
    if (is_faced) svg += planet_part(section, slice, -1.0);
  }
  svg += planet_neck(section, 1.0);
  if (is_faced) svg += planet_neck(section, -1.0);
  return svg + center_lines(section) + dimensions(section) + labels(section) + notes(section);
}

}  // namespace torquewright::report
