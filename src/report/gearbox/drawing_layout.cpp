// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/drawing_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/constraints/shifted_gears.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train/cut_train.hpp"
#include "src/report/parts/svg.hpp"

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
  const gearbox::Topology* topology = gearbox::find_topology(drawing.topology);
  require(topology != nullptr, "drawing: unknown topology");
  require(drawing.teeth.size() == topology->gears.size(), "drawing: wrong number of gears");
  for (const std::int64_t teeth : drawing.teeth) {
    require(teeth >= 1 && teeth <= kMaxTeeth, "drawing: teeth outside [1, 1000000]");
  }
  require(drawing.planet_count >= 1 && drawing.planet_count <= kMaxPlanets,
          "drawing: planets outside [1, 1000]");
  require(drawing.module_mm >= 1e-6 && drawing.module_mm <= 1e6,
          "drawing: module outside [1e-6, 1e6] mm");
  const double second_mm = drawing.layer_2_module_mm.value_or(drawing.module_mm);
  require(second_mm >= 1e-6 && second_mm <= 1e6, "drawing: module outside [1e-6, 1e6] mm");
  require(drawing.profile_shift.empty() || drawing.profile_shift.size() == drawing.teeth.size(),
          "drawing: wrong number of profile shifts");
  require(std::all_of(drawing.profile_shift.begin(), drawing.profile_shift.end(),
                      [](double shift) { return std::abs(shift) <= 100.0; }),
          "drawing: profile shift outside [-100, 100]");
  require(std::abs(drawing.hollow_shaft_diameter_mm) <= kMaxLength_mm,
          "drawing: hollow shaft outside [-1e9, 1e9] mm");
  require(std::all_of(drawing.face_width_mm.begin(), drawing.face_width_mm.end(),
                      [](double width_mm) { return width_mm > 0.0 && width_mm <= kMaxLength_mm; }),
          "drawing: face width outside (0, 1e9] mm");
  const double wall_mm = drawing.ring_wall_mm.value_or(0.0);
  require(wall_mm >= 0.0 && wall_mm <= kMaxLength_mm, "drawing: ring wall outside [0, 1e9] mm");
}

/// Absent where there are too few or too many teeth to draw, or flanks that cross before the tip.
std::optional<gearbox::ToothForm> form_of(const gearbox::CutGear& gear) {
  if (gear.teeth < gearbox::kMinDrawnTeeth || gear.teeth > kMaxDrawnTeeth) return std::nullopt;
  try {
    gearbox::ToothForm form = gear.internal
                                  ? gearbox::internal_gear(gear.teeth, gear.shift, gear.root_depth)
                                  : gearbox::external_gear(gear.teeth, gear.shift, gear.root_depth);
    form.tip_radius = 0.5 * gear.tip_diameter;
    return form;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

DrawnGear make_gear(const gearbox::DrawnPart& part, const gearbox::CutGear& gear) {
  return {.id = std::string(part.shape),
          .symbol = std::string(part.symbol),
          .label = std::string(part.label),
          .layer = gear.layer == 0 ? "1" : "2",
          .teeth = gear.teeth,
          .internal = gear.internal,
          .module_mm = gear.module_mm,
          .shift = gear.shift,
          .form = form_of(gear),
          .tip_radius = std::max(0.0, 0.5 * gear.tip_diameter),
          .root_radius = std::max(0.0, 0.5 * gear.root_diameter())};
}

/// The roots are those of the cutters that strength and report name.
void cut_roots(const gearbox::CutTrain& cut, std::vector<DrawnGear>& gears) {
  const std::vector<gearbox::GearCutter> cutters = gearbox::gear_cutters(cut);
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    if (!gears[i].form) continue;
    gears[i].form->fillet_radius = cutters[i].tip_radius;
    gears[i].form->shaper_teeth = cutters[i].shaper_teeth;
  }
}

gearbox::CutTrain cut_for(const DrawnGearbox& drawing) {
  gearbox::GearTrain train{drawing.topology,     drawing.teeth,     drawing.profile_shift,
                           drawing.planet_count, drawing.module_mm, {},
                           drawing.cutters};
  train.layer_2_module_mm = drawing.layer_2_module_mm;
  const auto cut = gearbox::cut_train(train);
  require(cut.has_value(), "drawing: the shifts of sun and planet leave no working angle");
  return *cut;
}

/// Gears, a view of each layer, and how they stand.
void add_parts(DrawingLayout& layout, const gearbox::CutTrain& cut) {
  const gearbox::Topology& topology = *gearbox::find_topology(layout.drawing.topology);
  for (std::size_t i = 0; i < topology.gears.size(); ++i) {
    layout.gears.push_back(make_gear(topology.drawn[i], cut.gears[i]));
  }
  for (std::size_t layer = 0; layer < topology.views.size(); ++layer) {
    layout.layers.push_back({std::string(topology.views[layer]),
                             gearbox::TrainParts::planet_of_layer(layer),
                             topology.ring_of_layer(layer), layer > 0});
  }
  layout.phase = topology.assemble(layout.drawing.teeth, layout.drawing.planet_count);
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

/// Widths as stated, else ten modules; one module between layers.
void add_widths(DrawingLayout& layout) {
  layout.face_width_mm = layout.drawing.face_width_mm;
  layout.is_width_assumed = layout.face_width_mm.size() != layout.layers.size();
  layout.layer_gap_mm = layout.drawing.module_mm;
  if (!layout.is_width_assumed) return;
  layout.face_width_mm.clear();
  for (const DrawnLayer& layer : layout.layers) {
    layout.face_width_mm.push_back(gearbox::kAssumedFaceModules *
                                   layout.gears[layer.planet].module_mm);
  }
}

/// Across the tips of opposite planets.
double planets_reach_mm(const DrawingLayout& layout, const DrawnLayer& layer) {
  const DrawnGear& planet = layout.gears[layer.planet];
  return 2.0 * (layout.center_distance_mm + planet.module_mm * planet.tip_radius);
}

double largest_diameter_mm(const DrawingLayout& layout) {
  double largest_mm = 0.0;
  for (const DrawnLayer& layer : layout.layers) {
    largest_mm =
        std::max({largest_mm, planets_reach_mm(layout, layer), outer_diameter_mm(layout, layer)});
  }
  return largest_mm;
}

}  // namespace

double axial_length_mm(const DrawingLayout& layout) {
  const double gaps_mm = layout.layer_gap_mm * static_cast<double>(layout.layers.size() - 1);
  return std::accumulate(layout.face_width_mm.begin(), layout.face_width_mm.end(), gaps_mm);
}

double ring_wall_mm(const DrawingLayout& layout, const DrawnGear& ring) {
  return layout.drawing.ring_wall_mm.value_or(kDefaultWall * ring.module_mm);
}

double blank_diameter_mm(const DrawingLayout& layout, const DrawnGear& ring) {
  return 2.0 * (ring.module_mm * ring.root_radius + ring_wall_mm(layout, ring));
}

double outer_diameter_mm(const DrawingLayout& layout, const DrawnLayer& layer) {
  return layer.ring ? blank_diameter_mm(layout, layout.gears[*layer.ring])
                    : planets_reach_mm(layout, layer);
}

DrawingLayout lay_out(const DrawnGearbox& drawing) {
  require_drawing(drawing);
  const gearbox::CutTrain cut = cut_for(drawing);
  DrawingLayout layout;
  layout.drawing = drawing;
  add_parts(layout, cut);
  cut_roots(cut, layout.gears);
  const double sum = static_cast<double>(drawing.teeth[0] + drawing.teeth[1]);
  layout.center_distance_mm = layout.is_shifted() ? cut.centre_mm : 0.5 * sum * drawing.module_mm;
  for (const gearbox::CutMesh& mesh : cut.meshes) {
    const gearbox::CutGear& ring = cut.gears[mesh.gear_2];
    if (!ring.internal) continue;
    const bool closes =
        mesh.closing_ring_shift &&
        std::abs(*mesh.closing_ring_shift - ring.shift) <= gearbox::kCoaxialTolerance;
    if (!closes) layout.is_coaxial = false;
  }
  layout.carrier_clearance_rad = std::numbers::pi / static_cast<double>(drawing.planet_count) -
                                 std::asin(static_cast<double>(drawing.teeth[1]) / sum);
  add_widths(layout);
  choose_scale(layout, std::max(largest_diameter_mm(layout), axial_length_mm(layout)));
  return layout;
}

}  // namespace torquewright::report
