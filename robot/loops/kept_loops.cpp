// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/kept_loops.hpp"

#include <fmt/format.h>

#include "robot/loops/kept_loop.hpp"
#include "robot/loops/narrowed_range.hpp"

namespace torquewright::hopper {
namespace {

std::string name_to_open(const Connect& connect) {
  const std::string own = attribute(*connect.element, "name");
  return own.empty() ? connect.names[1] : own;
}

std::vector<dynamics::Joint> joints_of(const GeneralLoop& loop,
                                       const std::vector<DraftBody>& drafts) {
  std::vector<dynamics::Joint> joints;
  for (const std::size_t joint : loop.joints) joints.push_back(drafts[joint].body.joint);
  return joints;
}

}  // namespace

void KeptLoops::add(const Connect& connect, std::string why) {
  connects_.push_back(connect);
  why_[connect.element] = std::move(why);
}

void KeptLoops::make(std::vector<DraftBody>& narrowed, Imported& imported, Faults& faults) {
  for (const std::vector<Connect>& group : connected(draft_, connects_)) {
    const Connect& first = group.front();
    const auto refuse = [&](const std::string& why) {
      faults.report(*first.element,
                    fmt::format("closes a loop between \"{}\" and \"{}\": {}; {}", first.names[0],
                                first.names[1], why_.at(first.element), why));
    };
    auto made = general_loop_of(draft_, group, driven_);
    if (const auto* objection = std::get_if<std::string>(&made)) {
      refuse(fmt::format("nor is it a loop of other shape: {}; --open-loop {} opens it", *objection,
                         name_to_open(first)));
      continue;
    }
    GeneralLoop loop = std::get<GeneralLoop>(std::move(made));
    if (loop.mechanism) {
      narrow_held(*loop.mechanism, loop.joints, loop.turned, draft_, narrowed, imported.notes);
    }
    const std::vector<dynamics::Joint> joints = joints_of(loop, narrowed);
    const std::string end = loop.mechanism ? end_within_range(*loop.mechanism, joints)
                                           : stuck_joint(*loop.follower, joints);
    if (!end.empty()) {
      refuse("as a loop of other shape " + end);
      continue;
    }
    loops_.push_back(std::move(loop));
  }
}

std::vector<std::size_t> KeptLoops::links() const {
  std::vector<std::size_t> links;
  for (const GeneralLoop& loop : loops_) {
    links.insert(links.end(), loop.links.begin(), loop.links.end());
  }
  return links;
}

void KeptLoops::put_in_robot(const std::vector<std::size_t>& index, Imported& imported) const {
  for (const GeneralLoop& loop : loops_) {
    const KeptLoop kept{loop, draft_, driven_, options_.drops_link_mass};
    if (loop.mechanism) {
      imported.robot.drivetrains.push_back(kept.drivetrain(index));
      for (const std::size_t turned : loop.turned) {
        const dynamics::Joint& joint = draft_[turned].body.joint;
        imported.loop_drives[drive_of(draft_, driven_, turned)] = {
            joint.kind == dynamics::JointKind::kPrismatic, joint.limits, 0.0, 0.0};
      }
    } else {
      imported.robot.followers.push_back(kept.follower(index));
    }
    kept.add_notes(why_.at(loop.connects.front().element), imported.notes);
  }
}

}  // namespace torquewright::hopper
