// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/import_options.hpp"

namespace torquewright::cli {

/// The values of --feet: NAME, or NAME=X0:X1,Y0:Y1,Z in m. io::SpecError where one is neither.
std::vector<hopper::NamedFeet> named_feet(const std::vector<std::string>& values);

}  // namespace torquewright::cli
