// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/problem.hpp"
#include "gearbox/proof/reading/verdict.hpp"

namespace torquewright::gearbox {

/// The result as it would be written of what it proves: status, designs, ties, conflict and bounds
/// that would do are taken from `result`, all that is said about them is evaluated afresh, and the
/// search is counted in the proof. Without "certificate", "problem", "inputs" and "options".
/// Requires a result whose proof was accepted, with these `counts`.
nlohmann::json restated(const Problem& problem, const nlohmann::json& result,
                        const proof::Counts& counts);

}  // namespace torquewright::gearbox
