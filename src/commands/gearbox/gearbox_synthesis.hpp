// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "src/commands/gearbox/gearbox_result_json.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {

/// `gearbox optimize` of a problem with `synthesis`. Throws io::SpecError for options that it does
/// not know.
ExitCode run_synthesis(const OptimizeRequest& request, const ReadProblem& read,
                       const std::function<bool()>& is_over);

}  // namespace torquewright::cli
