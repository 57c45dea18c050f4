// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/teeth/tooth_outline.hpp"
#include "src/report/workshop/gear_data.hpp"

namespace torquewright::report {

/// A DXF file (R12, millimetres) with every gear once, side by side, each on a layer of its name:
/// its whole outline as one closed polyline, true involutes and the roots that hob and shaper
/// leave, no chord farther than 0.2 micrometre from its curve; a ring's blank, the bore for a
/// hollow shaft, the middle; its pitch circle on the layer PITCH; its data and what is measured on
/// the layer DATA. Gears that have no outline (too few or too many teeth, pointed tips) are their
/// tip and root circles, which their data say.
std::string gear_dxf(const DrawingLayout& layout, const std::vector<GearData>& data);

/// Where the middle of each gear lies in that file [mm].
std::vector<gearbox::Point> dxf_middles(const DrawingLayout& layout);

}  // namespace torquewright::report
