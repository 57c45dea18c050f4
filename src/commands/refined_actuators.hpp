// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "io/atomic_file.hpp"
#include "src/options/identify_request.hpp"
#include "src/report/identification_html.hpp"

namespace torquewright::cli {

/// The document of one joint's actuator with what was found, and the same as read back.
struct RefinedActuator {
  std::string joint;
  std::string text;
  actuator::ReadActuator read;
};

/// Those of all joints, in the rig's order; empty where nothing is sure: an actuator with nothing
/// added to it would only look refined. One that its own reader refuses is said on stderr and left
/// out, with all others.
std::vector<RefinedActuator> refined_actuators(const IdentifyInputs& inputs,
                                               const identification::Identification& found);

/// What is to be written for -o; on stderr where nothing is, though it was asked for.
std::vector<io::FileContent> refined_files(const IdentifyInputs& inputs,
                                           const std::vector<RefinedActuator>& refined);

/// The regions as stated and refined, of the actuators that changed.
std::vector<report::RegionSection> region_sections(const IdentifyInputs& inputs,
                                                   const std::vector<RefinedActuator>& refined);

}  // namespace torquewright::cli
