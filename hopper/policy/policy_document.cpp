// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/policy_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/text/units.hpp"

namespace torquewright::hopper {

std::string unit_in_name(const std::string& name) {
  // Beside the units of columns the one that they write otherwise.
  if (name.ends_with("_m_s")) return "m/s";
  // From the longest ending on: _rad_s before _s.
  for (std::size_t at = name.find('_'); at != std::string::npos; at = name.find('_', at + 1)) {
    const std::optional<io::Unit> unit = io::find_unit(name.substr(at + 1));
    if (unit) return std::string(unit->name);
  }
  return "1";
}

double course_at(const PolicyOutput& output, long period) {
  if (output.course.empty()) return 0.0;
  const auto last = static_cast<long>(output.course.size()) - 1;
  return output.course[static_cast<std::size_t>(std::clamp(period, 0L, last))];
}

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
