// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/sweep/swept.hpp"

namespace torquewright::report {

/// A line a point, and what they come to.
std::string sweep_text(const sweep::Swept& swept);

}  // namespace torquewright::report
