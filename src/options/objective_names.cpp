// SPDX-License-Identifier: Apache-2.0
#include "src/options/objective_names.hpp"

#include "hopper/flip/objectives/library.hpp"

namespace torquewright::cli {

std::vector<std::string> objective_names() { return hopper::objective_names(); }

}  // namespace torquewright::cli
