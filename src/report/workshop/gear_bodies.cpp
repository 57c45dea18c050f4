// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/gear_bodies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "gearbox/topologies/topology.hpp"

namespace torquewright::report {
namespace {

std::vector<OutlinePiece> outline_of(const std::string& name, const DrawnGear& gear) {
  if (!gear.form) {
    throw std::invalid_argument(
        fmt::format("{} of {} teeth and profile shift {:g} has no outline: fewer than 7 teeth, "
                    "more than 600, or flanks that cross before the tip",
                    name, gear.teeth, gear.shift));
  }
  try {
    return outline_pieces(*gear.form, gear.module_mm);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name, error.what()));
  }
}

void require_rim(const GearBody& body, const DrawnGear& gear) {
  const double root_mm = 2.0 * gear.module_mm * gear.root_radius;
  if (body.is_ring || body.circle_diameter_mm < root_mm) return;
  throw std::invalid_argument(
      fmt::format("{}: a bore of {:g} mm leaves no rim in a root of {:g} mm", body.name,
                  body.circle_diameter_mm, root_mm));
}

GearBody body_of(const DrawingLayout& layout, const BodySizes& sizes, std::size_t gear) {
  const gearbox::Topology& topology = *gearbox::find_topology(layout.drawing.topology);
  const DrawnGear& drawn = layout.gears[gear];
  GearBody body;
  body.name = topology.gears[gear];
  body.shape = drawn.id;
  body.is_ring = drawn.internal;
  body.outline = outline_of(body.name, drawn);
  body.circle_diameter_mm = body.is_ring ? blank_diameter_mm(layout, drawn) : sizes.bore_mm[gear];
  body.width_mm = sizes.face_width_mm[topology.gear_layers[gear]];
  require_rim(body, drawn);
  return body;
}

void place_planets(const DrawingLayout& layout, std::size_t gear, PlacedBody placed,
                   GearBodies& bodies) {
  const gearbox::Topology& topology = *gearbox::find_topology(layout.drawing.topology);
  const std::string name = placed.name;
  const std::size_t count = layout.phase.planets.size();
  for (std::size_t i = 0; i < count; ++i) {
    const gearbox::PlanetPhase& planet = layout.phase.planets[i];
    placed.name = fmt::format("{} {} of {}", name, i + 1, count);
    placed.middle = gearbox::turned({layout.center_distance_mm, 0.0}, planet.position_rad);
    placed.turn_rad = topology.gear_layers[gear] == 0 ? planet.planet_1_rad : planet.planet_2_rad;
    bodies.placed.push_back(placed);
  }
}

void place(const DrawingLayout& layout, std::size_t gear, double from_mm, GearBodies& bodies) {
  const bool is_first = gearbox::find_topology(layout.drawing.topology)->gear_layers[gear] == 0;
  PlacedBody placed;
  placed.body = gear;
  placed.name = bodies.bodies[gear].name;
  placed.from_mm = from_mm;
  if (layout.gears[gear].internal) {
    placed.turn_rad = is_first ? layout.phase.fixed_ring_rad : layout.phase.output_ring_rad;
  } else if (gear == 0) {
    placed.turn_rad = layout.phase.sun_rad;
  } else {
    place_planets(layout, gear, placed, bodies);
    return;
  }
  bodies.placed.push_back(placed);
}

}  // namespace

GearBodies gear_bodies(const DrawingLayout& layout, const BodySizes& sizes) {
  const gearbox::Topology& topology = *gearbox::find_topology(layout.drawing.topology);
  GearBodies bodies;
  bodies.name = layout.drawing.name;
  for (std::size_t gear = 0; gear < layout.gears.size(); ++gear) {
    bodies.bodies.push_back(body_of(layout, sizes, gear));
    const double from_mm = topology.gear_layers[gear] == 0 ? 0.0 : sizes.face_width_mm.front();
    place(layout, gear, from_mm, bodies);
  }
  return bodies;
}

gearbox::Point placed_point(const PlacedBody& placed, const gearbox::Point& point) {
  const gearbox::Point turned = gearbox::turned(point, placed.turn_rad);
  return {placed.middle.x + turned.x, placed.middle.y + turned.y};
}

}  // namespace torquewright::report
