// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/planning/search/plan.hpp"

namespace torquewright::report {

/// The page of a plan: what came of it, and below it the page of `hopper check` on the motion that
/// was found, where that could be checked. Needs nothing else; what users wrote is escaped.
std::string flip_html(const hopper::Robot& robot, const hopper::PlanOptions& options,
                      const hopper::PlanResult& result);

}  // namespace torquewright::report
