// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/report/workshop/gear_bodies.hpp"
#include "src/report/workshop/step_file.hpp"

namespace torquewright::report {

/// Directions and points that all entities of a file may share.
struct StepFrame {
  StepId along_x;
  StepId along_z;
  StepId up;         ///< A vector of 1 mm along z.
  StepId placement;  ///< At the origin, axis z.
};

StepFrame add_frame(StepFile& file);

/// Adds the body about the z axis from z = 0 upwards, a MANIFOLD_SOLID_BREP: planes, cylinders, and
/// flanks and fillets as extruded B-splines. Returns its number.
StepId add_solid(StepFile& file, const StepFrame& frame, const GearBody& body);

/// Adds an AXIS2_PLACEMENT_3D with its axis along z, turned about it.
StepId add_placement(StepFile& file, const StepFrame& frame, const gearbox::Point& place,
                     double z_mm, double turn_rad);

}  // namespace torquewright::report
