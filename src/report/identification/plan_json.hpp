// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "identification/experiment/plan.hpp"

namespace torquewright::report {

/// A plan as a document without its provenance ("tool", "inputs"). An infinite error is null.
nlohmann::ordered_json plan_json(const identification::Plan& plan,
                                 const identification::PlanOptions& options);

}  // namespace torquewright::report
