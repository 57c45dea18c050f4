// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/layers/layers.hpp"

namespace torquewright::layers {

/// The files that include themselves by way of others, or lie between two such circles, by their
/// names without extension: a header and its source are one.
std::set<std::string> files_in_circles(const std::vector<SourceFile>& sources);

}  // namespace torquewright::layers
