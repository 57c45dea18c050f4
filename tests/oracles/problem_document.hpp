// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "gearbox/problem.hpp"

namespace torquewright::oracles {

/// The problem as a document of kind `gearbox_problem`, so that whatever was seen with it can be
/// seen again with the program. Every number of the problem must be a decimal of at most 15 digits.
nlohmann::json problem_document(const gearbox::Problem& problem);

}  // namespace torquewright::oracles
