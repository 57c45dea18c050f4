// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "identification/plan.hpp"

namespace torquewright::report {

/// What `identify plan` says: each parameter's expected error beside a chirp's, and what no
/// excitation of this rig separates.
std::string plan_text(const identification::Plan& plan, const identification::PlanOptions& options);

/// The same as a document without its provenance ("tool", "inputs"). An infinite error is null.
nlohmann::ordered_json plan_json(const identification::Plan& plan,
                                 const identification::PlanOptions& options);

}  // namespace torquewright::report
