// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/trajectory/columns.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::actuator {

/// Message that a mapping's factor is 0.
inline constexpr const char* kNoFactor = "0 would leave nothing of the column";

/// Reads the mappings of a document of kind `trajectory_columns`. Throws io::SpecError for unknown
/// units, a factor of 0, and a quantity without its joint.
std::vector<ColumnMapping> read_columns(const io::Document& document);

}  // namespace torquewright::actuator
