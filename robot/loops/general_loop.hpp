// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/loops/rod_loop.hpp"
#include "robot/mechanisms/loop.hpp"

namespace torquewright::hopper {

/// Loops of a file that share joints, kept with their own bodies. By the drafts' indices.
struct GeneralLoop {
  std::vector<Connect> connects;
  std::vector<std::size_t> joints;  ///< The robot's own.
  std::vector<std::size_t> links;
  std::vector<std::size_t> turned;  ///< Of both, those that a drive turns or pushes.
  std::shared_ptr<const Loop> mechanism;
  /// In its place where drives turn the robot's own joints alone, or none: the links follow.
  std::shared_ptr<const ClosedLinks> follower;

  const LoopGeometry& geometry() const {
    return mechanism ? mechanism->geometry() : follower->geometry();
  }
  bool has_link(std::size_t draft) const {
    return std::find(links.begin(), links.end(), draft) != links.end();
  }
};

/// Connects in groups that share joints; in the order of the file.
std::vector<std::vector<Connect>> connected(const std::vector<DraftBody>& draft,
                                            const std::vector<Connect>& connects);

/// The loops as one mechanism, or why they are none, in a sentence. As many joints stay the
/// robot's own as drives turn joints of the loops: those that carry other bodies, then those that
/// carry the most. All others are links. Where more carry others than drives turn, all of them and
/// those that are driven stay, and the links follow.
std::variant<GeneralLoop, std::string> general_loop_of(const std::vector<DraftBody>& draft,
                                                       const std::vector<Connect>& connects,
                                                       const DrivenJoints& driven);

}  // namespace torquewright::hopper
