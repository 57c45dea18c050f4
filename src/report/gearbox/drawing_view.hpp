// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/gearbox/drawing_layout.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {

/// The shapes of all gears, to be placed by views; one definition each.
std::string shape_definitions(const DrawingLayout& layout);

/// One layer about `center` on paper, with centre lines, dimensions and labels. The first planet
/// stands above the sun.
std::string layer_view(const DrawingLayout& layout, const DrawnLayer& layer, const Point& center);

}  // namespace torquewright::report
