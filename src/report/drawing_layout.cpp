// SPDX-License-Identifier: Apache-2.0
#include "src/report/drawing_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gearbox/constraints/gear_cutters.hpp"
#include "src/report/svg.hpp"

namespace torquewright::report {
namespace {

constexpr double kViewDiameter_mm = 170.0;  // Room on paper for the largest circle of a view.
constexpr std::int64_t kMaxDrawnTeeth = 600;
constexpr std::int64_t kMaxTeeth = 1'000'000;
constexpr std::int64_t kMaxPlanets = 1000;
constexpr double kMaxLength_mm = 1e9;
constexpr double kDefaultWall = 2.25;  // Modules: one tooth height.

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

void require_drawing(const DrawnGearbox& drawing) {
  const bool is_3k = drawing.topology == "3k";
  require(is_3k || drawing.topology == "planetary", "drawing: unknown topology");
  require(drawing.teeth.size() == (is_3k ? 5u : 3u), "drawing: wrong number of gears");
  for (const std::int64_t teeth : drawing.teeth) {
    require(teeth >= 1 && teeth <= kMaxTeeth, "drawing: teeth outside [1, 1000000]");
  }
  require(drawing.planet_count >= 1 && drawing.planet_count <= kMaxPlanets,
          "drawing: planets outside [1, 1000]");
  require(drawing.module_mm >= 1e-6 && drawing.module_mm <= 1e6,
          "drawing: module outside [1e-6, 1e6] mm");
  require(std::abs(drawing.hollow_shaft_diameter_mm) <= kMaxLength_mm,
          "drawing: hollow shaft outside [-1e9, 1e9] mm");
  const double wall_mm = drawing.ring_wall_mm.value_or(0.0);
  require(wall_mm >= 0.0 && wall_mm <= kMaxLength_mm, "drawing: ring wall outside [0, 1e9] mm");
}

DrawnGear make_gear(std::string id, std::string symbol, std::string label, std::string layer,
                    std::int64_t teeth, bool internal) {
  const double pitch_radius = 0.5 * static_cast<double>(teeth);
  DrawnGear gear{.id = std::move(id),
                 .symbol = std::move(symbol),
                 .label = std::move(label),
                 .layer = std::move(layer),
                 .teeth = teeth,
                 .internal = internal,
                 .form = std::nullopt,
                 .tip_radius = std::max(0.0, pitch_radius + (internal ? -1.0 : 1.0)),
                 .root_radius = std::max(0.0, pitch_radius + (internal ? 1.25 : -1.25))};
  if (teeth < gearbox::kMinDrawnTeeth || teeth > kMaxDrawnTeeth) return gear;
  gear.form = internal ? gearbox::internal_gear(teeth) : gearbox::external_gear(teeth);
  return gear;
}

// The roots are those of the cutters that strength and report name.
void cut_roots(const DrawnGearbox& drawing, std::vector<DrawnGear>& gears) {
  const gearbox::GearTrain train{
      drawing.topology,     drawing.teeth,     std::vector(drawing.teeth.size(), 0.0),
      drawing.planet_count, drawing.module_mm, {},
      drawing.cutters};
  const std::vector<gearbox::GearCutter> cutters = gearbox::gear_cutters(train);
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    if (!gears[i].form) continue;
    gears[i].form->fillet_radius = cutters[i].tip_radius;
    gears[i].form->shaper_teeth = cutters[i].shaper_teeth;
  }
}

void add_3k(DrawingLayout& layout) {
  const std::vector<std::int64_t>& teeth = layout.drawing.teeth;
  layout.gears = {make_gear("sun", "S", "sun", "1", teeth[0], false),
                  make_gear("planet_1", "P1", "planet 1", "1", teeth[1], false),
                  make_gear("planet_2", "P2", "planet 2", "2", teeth[2], false),
                  make_gear("fixed_ring", "F", "fixed ring", "1", teeth[3], true),
                  make_gear("output_ring", "O", "output ring", "2", teeth[4], true)};
  layout.layers = {{"Layer 1: sun, planets 1, fixed ring", 1, 3, false},
                   {"Layer 2: planets 2, output ring (sun dashed)", 2, 4, true}};
  layout.phase = gearbox::assemble_3k({teeth[0], teeth[1], teeth[2], teeth[3], teeth[4]},
                                      layout.drawing.planet_count);
}

void add_planetary(DrawingLayout& layout) {
  const std::vector<std::int64_t>& teeth = layout.drawing.teeth;
  layout.gears = {make_gear("sun", "S", "sun", "1", teeth[0], false),
                  make_gear("planet_1", "P", "planet", "1", teeth[1], false),
                  make_gear("fixed_ring", "R", "ring", "1", teeth[2], true)};
  layout.layers = {{"Sun, planets, ring", 1, 2, false}};
  layout.phase =
      gearbox::assemble_planetary(teeth[0], teeth[1], teeth[2], layout.drawing.planet_count);
}

// The largest usual scale at which `diameter_mm` finds room: preferred steps between the decades.
void choose_scale(DrawingLayout& layout, double diameter_mm) {
  constexpr std::array<double, 9> kSteps{1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
  for (double decade = 1e6; decade >= 1.0; decade /= 10.0) {
    for (auto step = kSteps.rbegin(); step != kSteps.rend(); ++step) {
      layout.scale = *step * decade;
      layout.scale_text = decimal(layout.scale) + ":1";
      if (layout.scale * diameter_mm <= kViewDiameter_mm) return;
    }
  }
  for (double decade = 1.0; decade <= 1e12; decade *= 10.0) {
    for (const double step : kSteps) {
      layout.scale = 1.0 / (step * decade);
      layout.scale_text = "1:" + decimal(step * decade);
      if (layout.scale * diameter_mm <= kViewDiameter_mm) return;
    }
  }
}

double largest_diameter_mm(const DrawingLayout& layout) {
  double largest_mm = 0.0;
  for (const DrawnLayer& layer : layout.layers) {
    const double reach_mm = layout.center_distance_mm +
                            layout.drawing.module_mm * layout.gears[layer.planet].tip_radius;
    largest_mm =
        std::max({largest_mm, 2.0 * reach_mm, blank_diameter_mm(layout, layout.gears[layer.ring])});
  }
  return largest_mm;
}

}  // namespace

double blank_diameter_mm(const DrawingLayout& layout, const DrawnGear& ring) {
  return 2.0 * (layout.drawing.module_mm * ring.root_radius + layout.ring_wall_mm);
}

DrawingLayout lay_out(const DrawnGearbox& drawing) {
  require_drawing(drawing);
  DrawingLayout layout;
  layout.drawing = drawing;
  drawing.topology == "3k" ? add_3k(layout) : add_planetary(layout);
  cut_roots(drawing, layout.gears);
  const double sum = static_cast<double>(drawing.teeth[0] + drawing.teeth[1]);
  layout.center_distance_mm = 0.5 * sum * drawing.module_mm;
  layout.ring_wall_mm = drawing.ring_wall_mm.value_or(kDefaultWall * drawing.module_mm);
  for (const DrawnLayer& layer : layout.layers) {
    const DrawnGear& planet = layout.gears[layer.planet];
    const DrawnGear& ring = layout.gears[layer.ring];
    if (ring.teeth - planet.teeth != drawing.teeth[0] + drawing.teeth[1]) layout.is_coaxial = false;
  }
  layout.carrier_clearance_rad = std::numbers::pi / static_cast<double>(drawing.planet_count) -
                                 std::asin(static_cast<double>(drawing.teeth[1]) / sum);
  choose_scale(layout, largest_diameter_mm(layout));
  return layout;
}

}  // namespace torquewright::report
