// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/train/assembly_phase.hpp"
#include "src/report/gearbox/drawn_gearbox.hpp"

namespace torquewright::report {

/// One kind of gear of the drawing; radii in modules.
struct DrawnGear {
  std::string id;      ///< Of the shape and of its colour: sun, planet_1, ...
  std::string symbol;  ///< As in the documentation: S, P1, ...
  std::string label;
  std::string layer;
  std::int64_t teeth = 0;
  bool internal = false;
  double module_mm = 0.0;
  double shift = 0.0;
  std::optional<gearbox::ToothForm> form;  ///< Absent: drawn as circles.
  double tip_radius = 0.0;
  double root_radius = 0.0;
};

/// What one view shows: indices into the layout's gears.
struct DrawnLayer {
  std::string title;
  std::size_t planet = 0;
  std::optional<std::size_t> ring = {};  ///< Planets without one reach as far as they go.
  bool is_second = false;                ///< The sun is only hinted at.
};

/// Everything of a drawing that is decided before a line is drawn.
struct DrawingLayout {
  DrawnGearbox drawing;
  std::vector<DrawnGear> gears;  ///< In the topology's order.
  std::vector<DrawnLayer> layers;
  gearbox::AssemblyPhase phase;
  double center_distance_mm = 0.0;
  double scale = 1.0;                  ///< Paper over gearbox.
  std::string scale_text;              ///< "2:1"
  double carrier_clearance_rad = 0.0;  ///< pi/n - asin(P1/(S + P1)), half of the angle drawn.
  std::vector<double> face_width_mm;   ///< Of each layer.
  bool is_width_assumed = false;
  double layer_gap_mm = 0.0;  ///< Between two layers: nobody states it.
  bool is_coaxial = true;     ///< All meshes fit one centre distance with the shifts drawn.

  bool is_shifted() const {
    return !drawing.profile_shift.empty() || drawing.layer_2_module_mm.has_value();
  }
};

/// Throws std::invalid_argument as gearbox_drawing() does.
DrawingLayout lay_out(const DrawnGearbox& drawing);

/// Of all layers and what is between them [mm].
double axial_length_mm(const DrawingLayout& layout);

/// Wall behind a ring's root, in mm: as stated, or one tooth height.
double ring_wall_mm(const DrawingLayout& layout, const DrawnGear& ring);

/// Outer diameter of a ring's blank [mm].
double blank_diameter_mm(const DrawingLayout& layout, const DrawnGear& ring);

/// Of a layer: of its ring's blank, or across the tips of opposite planets [mm].
double outer_diameter_mm(const DrawingLayout& layout, const DrawnLayer& layer);

}  // namespace torquewright::report
