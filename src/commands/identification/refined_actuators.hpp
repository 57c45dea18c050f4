// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/identification/identify_inputs.hpp"
#include "src/report/identification/identification_html.hpp"

namespace torquewright::cli {

/// The document of one joint's actuator with what was found, and the same as read back.
struct RefinedActuator {
  std::string joint;
  std::string text;
  actuator::ReadActuator read;
};

/// The refined actuators of all joints, in the rig's order; none where nothing is sure: an actuator
/// with nothing added to it would only look refined. `judged`: see refined_actuator() in
/// refined_json.hpp.
struct RefinedActuators {
  std::vector<RefinedActuator> of_joints;
  std::string refusal;  ///< What its own reader says against one of them; then there are none.
  /// The logs with the documents read back; nothing before they were judged.
  std::optional<identification::Identification> judged;
};

RefinedActuators refined_actuators(const IdentifyInputs& inputs,
                                   const identification::Identification& found,
                                   const identification::Identification* judged = nullptr);

/// Judges the documents on the request's logs and states in them what they leave; refuses those
/// that do not leave the error that was promised.
void judge_as_written(const IdentifyRequest& request, const IdentifyInputs& inputs,
                      const identification::Identification& found, RefinedActuators& refined);

/// What is to be written for -o; on stderr where nothing is, though it was asked for.
std::vector<io::FileContent> refined_files(const IdentifyInputs& inputs,
                                           const RefinedActuators& refined);

/// The regions as stated and refined, of the actuators that changed.
std::vector<report::RegionSection> region_sections(const IdentifyInputs& inputs,
                                                   const RefinedActuators& refined);

}  // namespace torquewright::cli
