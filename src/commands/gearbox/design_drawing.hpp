// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/problem.hpp"

namespace torquewright::cli {

/// The SVG sheet of a design of this problem.
std::string drawing_of(const gearbox::Problem& problem, const gearbox::Design& design);

}  // namespace torquewright::cli
