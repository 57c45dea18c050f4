// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/trajectory/columns.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper {

/// The mappings of a document of kind `trajectory_columns`, as stated: whether owners, quantities
/// and units exist is for who knows the robot.
std::vector<actuator::MappingText> read_mappings(const io::Document& document);

}  // namespace torquewright::hopper
