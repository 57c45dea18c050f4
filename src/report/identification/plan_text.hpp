// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/experiment/plan.hpp"

namespace torquewright::report {

/// What `identify plan` says: each parameter's expected error beside a chirp's, and what no
/// excitation of this rig separates.
std::string plan_text(const identification::Plan& plan, const identification::PlanOptions& options);

}  // namespace torquewright::report
