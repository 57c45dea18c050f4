// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "gearbox/problem.hpp"
#include "gearbox/proof/reading/verdict.hpp"

namespace torquewright::gearbox::proof {

/// Whether a `gearbox_result` proves what it says about the problem (docs/certificate.md): status,
/// designs, objective, bound, gap, conflict, would_be_feasible_with and certificate. Shares no code
/// with the search. Any JSON is taken; whatever is wrong with it becomes a fault, never an
/// exception. Sentences and descriptive numbers of the designs are not judged here. `should_stop`
/// is asked at every node and every design; where it is true the verdict is `ended`.
[[nodiscard]] Verdict check_certificate(
    const Problem& problem, const nlohmann::json& result,
    const std::function<bool()>& should_stop = [] { return false; });

}  // namespace torquewright::gearbox::proof
