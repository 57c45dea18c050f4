// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <vector>

#include "actuator/check/check.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "src/options/check_request.hpp"

namespace torquewright::cli {

/// What is to be checked, and every document that was read for it.
struct ActuatorCheckInputs {
  actuator::CheckRequest request;
  std::list<actuator::ReadActuator> actuators;  ///< The request points to them.
  std::vector<io::Document> documents;
};

/// Reads all documents; the trajectory is read as it is checked. Throws io::SpecError.
ActuatorCheckInputs read_inputs(const CheckOptions& options);

}  // namespace torquewright::cli
