// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/answer/identify.hpp"
#include "io/documents/document.hpp"
#include "src/options/identify_request.hpp"

namespace torquewright::cli {

/// What was read for a request. Both lists are in the order of the rig's joints.
struct IdentifyInputs {
  io::Document rig_document;
  identification::Rig rig;
  std::vector<identification::JointActuator> actuators;
  /// Files to be written, of a robot's joints an empty name for those that are not; empty: not
  /// asked for.
  std::vector<std::string> refined;
  /// Where all that was found of a robot is written; empty: not asked for.
  std::string refined_folder;
  std::vector<io::Document> robot_documents;  ///< Where the load is a robot: its own, its drives'.
};

/// Throws io::SpecError for what cannot be read, a joint that the rig does not have, one without an
/// actuator, and outputs that could not be written.
IdentifyInputs read_inputs(const IdentifyRequest& request);

}  // namespace torquewright::cli
