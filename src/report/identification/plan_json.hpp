// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "identification/experiment/plan.hpp"

namespace torquewright::report {

/// A plan as a document without its provenance ("tool", "inputs"). An infinite error is null.
/// `options` are the document's: what the command was asked.
nlohmann::ordered_json plan_json(const identification::Plan& plan, nlohmann::ordered_json options);

}  // namespace torquewright::report
