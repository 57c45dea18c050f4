// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/idle_limit.hpp"

#include "actuator/unlimited.hpp"

namespace torquewright::actuator::lint {

std::optional<Finding> idle_regeneration_limit(const Actuator& document) {
  const Drive& drive = document.drive;
  if (drive.regeneration || drive.regeneration_limit_W == kUnlimited) return std::nullopt;
  Finding finding;
  finding.rule = "idle-regeneration-limit";
  finding.actuator = document.name;
  finding.unit = "W";
  finding.stated = rounded(drive.regeneration_limit_W, "/drive/regeneration_limit_W");
  finding.expected = exact(0.0, "/drive/regeneration");
  finding.sentence =
      "/drive/regeneration_limit_W says " + with_interval(finding.stated, finding.unit) +
      ", and /drive/regeneration says that no power flows back: the limit is ignored; state one of "
      "them.";
  return finding;
}

}  // namespace torquewright::actuator::lint
