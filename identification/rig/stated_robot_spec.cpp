// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/stated_robot_spec.hpp"

#include <fmt/format.h>

#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification {

namespace fs = std::filesystem;

void state_robot(const fs::path& robot, io::Document& rig) {
  for (const char* key : {"load", "loads"}) {
    if (!rig.root.contains(key)) continue;
    io::refuse("--robot", fmt::format("the rig says itself what was moved, {}#/{}; leave one out",
                                      rig.file, key));
  }
  // A load's file lies beside the rig.
  const fs::path folder = fs::path(rig.file).parent_path();
  const fs::path beside =
      robot.is_absolute() || folder.empty() ? robot : fs::proximate(robot, folder);
  rig.root["load"] = {{"type", "robot"}, {"file", beside.string()}, {"base", "held"}};
}

}  // namespace torquewright::identification
