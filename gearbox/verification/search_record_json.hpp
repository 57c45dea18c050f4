// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/proof/reading/faults.hpp"
#include "gearbox/proof/reading/verdict.hpp"

namespace torquewright::gearbox {

/// Whether "search" and "options" go with the proof, as far as a proof can tell: solves, seconds
/// and the options that the search was given.
void check_search_record(const nlohmann::json& result, const proof::Counts& counts,
                         proof::Faults& faults);

}  // namespace torquewright::gearbox
