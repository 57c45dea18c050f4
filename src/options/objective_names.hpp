// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::cli {

/// What a plan can be asked to do best, by name.
std::vector<std::string> objective_names();

}  // namespace torquewright::cli
