// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/policy_document.hpp"

#include <fmt/format.h>

namespace torquewright::hopper {

std::string objection_to(const PolicyDocument& document) {
  const learning::Policy& policy = document.policy;
  const std::string objection = learning::objection_to(policy);
  if (!objection.empty()) return objection;
  const auto inputs = static_cast<std::size_t>(policy.inputs());
  const auto outputs = static_cast<std::size_t>(policy.outputs());
  if (document.inputs.size() != inputs) {
    return fmt::format("{} inputs are named, where the policy sees {} numbers",
                       document.inputs.size(), inputs);
  }
  if (document.outputs.size() != outputs) {
    return fmt::format("{} outputs are named, where the last layer has {}", document.outputs.size(),
                       outputs);
  }
  return "";
}

}  // namespace torquewright::hopper
