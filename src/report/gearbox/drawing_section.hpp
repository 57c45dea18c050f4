// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/gearbox/drawing_layout.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {

/// A cut along the axis through the first planet, which stands above the sun as in the views of the
/// layers, about `center` on paper and at their scale: gears as wide as they are, with dimensions.
/// What nobody states is dashed and named; of carrier, pins and bearings nothing is known.
std::string axial_section(const DrawingLayout& layout, const Point& center);

}  // namespace torquewright::report
