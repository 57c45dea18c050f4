// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "gearbox/problem.hpp"
#include "gearbox/verification/verification.hpp"

namespace torquewright::gearbox {

/// Checks the certificate, without the search; then compares everything else in the result with a
/// fresh evaluation of the proved designs, the counts with the proof, and the problem with the file
/// it was read from, if that is there. Requires a document of the shape of a `gearbox_result`, and
/// its problem. Of a synthesis see sized_verification_json.hpp. For `should_stop` see
/// proof::check_certificate.
[[nodiscard]] Verification verify(
    const Problem& problem, const nlohmann::json& result,
    const std::function<bool()>& should_stop = [] { return false; });

}  // namespace torquewright::gearbox
