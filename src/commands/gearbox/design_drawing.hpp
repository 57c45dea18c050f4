// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/problem.hpp"
#include "src/report/gearbox/drawn_gearbox.hpp"

namespace torquewright::cli {

/// What a drawing shows of a design of this problem.
report::DrawnGearbox drawn_gearbox(const gearbox::Problem& problem, const gearbox::Design& design);

/// The SVG sheet of a design of this problem.
std::string drawing_of(const gearbox::Problem& problem, const gearbox::Design& design);

}  // namespace torquewright::cli
