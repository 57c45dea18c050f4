// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/front/front_spec.hpp"

namespace torquewright::report {

/// A front as a table.
std::string front_text(const gearbox::Problem& problem, const gearbox::ShownFront& shown);

/// The same as an SVG picture: points, the staircase between them, and dashed their bounds. There
/// must be a point.
std::string front_svg(const gearbox::Problem& problem, const gearbox::ShownFront& shown);

}  // namespace torquewright::report
