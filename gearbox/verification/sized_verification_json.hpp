// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "gearbox/problem.hpp"
#include "gearbox/verification/verification.hpp"

namespace torquewright::gearbox {

/// verify() of a result of a problem with `synthesis`: its designs by `evaluate` and `strength`,
/// its bound by a proof of its own (sized_proof), and what else it says by what follows from these.
Verification verify_synthesis(const Problem& problem, const nlohmann::json& result,
                              const std::function<bool()>& should_stop);

}  // namespace torquewright::gearbox
