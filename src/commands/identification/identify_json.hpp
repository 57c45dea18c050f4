// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "src/commands/identification/identify_inputs.hpp"

namespace torquewright::cli {

/// The report as a document of kind identification_report.
std::string identify_json(const IdentifyRequest& request, const IdentifyInputs& inputs,
                          const identification::Identification& found);

/// A refined actuator as it is to stand in the output; empty: as it would stand where `nominal` is.
std::string refined_text(nlohmann::ordered_json document, const std::string& nominal,
                         const std::string& output);

}  // namespace torquewright::cli
