// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/workshop/step_file.hpp"

namespace torquewright::report {

/// A solid, and what it is drawn as: sun, planet_1, ...
struct ColouredSolid {
  StepId solid;
  std::string shape;
};

/// Gives solids the colours of the drawing sheet; `geometry` is their context.
void add_colours(StepFile& file, StepId geometry, const std::vector<ColouredSolid>& solids);

}  // namespace torquewright::report
