// SPDX-License-Identifier: Apache-2.0
#include "robot/model/follower_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "robot/find_name.hpp"
#include "robot/mechanisms/loop_geometry_spec.hpp"

namespace torquewright::hopper {

using nlohmann::json;
using nlohmann::ordered_json;

void read_followers(const io::Document& document, Robot& robot, std::vector<io::Fault>& faults) {
  const json entries = document.root.value("followers", json::array());
  std::vector<std::string> names;
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    names.push_back(robot.tree.bodies[i].joint.name);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string path = fmt::format("/followers/{}", i);
    Follower follower;
    for (std::size_t j = 0; j < entries[i]["joints"].size(); ++j) {
      const auto joint =
          find_name(names, entries[i]["joints"][j], "joint",
                    {document.file, fmt::format("{}/joints/{}", path, j), ""}, faults);
      if (joint) follower.joints.push_back(*joint + 1);
    }
    auto geometry = read_loop_geometry(
        {entries[i], robot.tree, follower.joints, {document.file, path, ""}, faults});
    if (!geometry) continue;
    follower.links = std::make_shared<ClosedLinks>(*std::move(geometry));
    robot.followers.push_back(std::move(follower));
  }
}

ordered_json follower_json(const Robot& robot, const Follower& follower) {
  ordered_json keys;
  for (const std::size_t body : follower.joints) {
    keys["joints"].push_back(robot.tree.bodies[body].joint.name);
  }
  keys.update(loop_geometry_keys(follower.links->geometry()));
  return keys;
}

}  // namespace torquewright::hopper
