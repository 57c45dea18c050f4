// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/synthesis/synthesis.hpp"
#include "src/commands/gearbox/gearbox_result_json.hpp"

namespace torquewright::cli {

/// What a synthesis found, as a document of kind gearbox_result.
std::string synthesis_result_json(const OptimizeRequest& request, const ReadProblem& read,
                                  const gearbox::SynthesisResult& found, double seconds);

}  // namespace torquewright::cli
