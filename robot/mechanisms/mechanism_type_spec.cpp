// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/mechanism_type_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace torquewright::hopper {

double MechanismKeys::number(const char* key, double otherwise) const {
  return keys.value(key, otherwise);
}

bool MechanismKeys::turn_only() const {
  const std::size_t before = faults.size();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const dynamics::Joint& joint = tree.bodies[joints[i]].joint;
    if (joint.kind == dynamics::JointKind::kRevolute) continue;
    report(fmt::format("/joints/{}", i),
           fmt::format("\"{}\" slides: this mechanism turns joints", joint.name));
  }
  return faults.size() == before;
}

void MechanismKeys::report(const std::string& key, std::string message) const {
  faults.push_back({place.file, place.path + key, std::move(message)});
}

}  // namespace torquewright::hopper
