// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/shared_battery.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/wording.hpp"

namespace torquewright::actuator {

std::vector<Finding> shared_battery_findings(const std::vector<CheckedDrive>& drives) {
  struct Group {
    const Battery* battery;
    std::vector<std::string> joints;
  };
  std::vector<Group> groups;
  for (const CheckedDrive& drive : drives) {
    if (!drive.actuator->battery) continue;
    const Battery& battery = *drive.actuator->battery;
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const Group& group) { return *group.battery == battery; });
    Group& group = same != groups.end() ? *same : groups.emplace_back(Group{&battery, {}});
    group.joints.push_back(drive.name);
  }
  std::vector<Finding> findings;
  for (const Group& group : groups) {
    if (group.joints.size() < 2) continue;
    Finding& finding = findings.emplace_back();
    finding.rule = "shared-battery";
    finding.sentence = fmt::format(
        "{} state the same battery; each was checked as if it had that alone. Together they draw "
        "more, so that bus voltage and power limit may fall short where this says that they do not",
        io::listed(group.joints));
  }
  return findings;
}

}  // namespace torquewright::actuator
