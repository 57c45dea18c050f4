// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "src/commands/identification/identify_inputs.hpp"
#include "src/report/identification/robot_report.hpp"

namespace torquewright::cli {

/// The report as a document of kind identification_report, with what simulations of the robot say
/// where there were any.
std::string identify_json(const IdentifyRequest& request, const IdentifyInputs& inputs,
                          const identification::Identification& found,
                          const std::optional<report::RobotReport>& robot);

/// A refined actuator as it is to stand in the output; empty: as it would stand where `nominal` is.
std::string refined_text(nlohmann::ordered_json document, const std::string& nominal,
                         const std::string& output);

}  // namespace torquewright::cli
