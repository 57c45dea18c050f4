// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/design/co_design.hpp"

namespace torquewright::report {

/// Which motor behind which gears does the motion: the gears of each ratio, the pairs that do it
/// by mass, and why each other one does not. With `all` every pair that does not.
std::string co_design_text(const hopper::Robot& robot, const hopper::CoDesignQuestion& question,
                           const hopper::CoDesign& design, bool all);

}  // namespace torquewright::report
