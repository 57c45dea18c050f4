// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/point.hpp"
#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

/// Two points of two drafts that stay together.
struct Connect {
  const Element* element = nullptr;
  std::array<dynamics::BodyPoint, 2> ends;
  std::array<std::string, 2> names;  ///< As the file calls what it joins.
};

/// Whether a user means it by that name: its own, or that of an end.
bool is_called(const Connect& connect, const std::string& name);
/// Whether it is called by one of them.
bool is_opened(const Connect& connect, const std::vector<std::string>& opened);

/// The drive that turns a joint, by the joint.
using DrivenJoints = std::map<std::string, std::string>;

/// A loop of a crank, a rod and what the rod moves, crank and first moved body on the same ground.
struct RodLoop {
  Connect connect;
  std::size_t ground = 0;
  std::size_t crank = 0;
  std::vector<std::size_t> rod;   ///< One to three hinges at one point, the rod the last of them.
  std::vector<std::size_t> held;  ///< One hinge or two, from the ground on.
  Eigen::Vector3d crank_pin_m;    ///< In the crank.
  Eigen::Vector3d held_pin_m;     ///< In the last of the held.
  Eigen::Vector3d rod_m;          ///< From the rod's hinges to its other pin, in the rod.
  bool hangs_on_crank = true;     ///< The rod, in the file's tree.
};

/// The loop as one of those, or why it is none, in a sentence. Where crank and moved body are one
/// hinge each, the crank is the one that a drive turns; where none is driven, the one that carries
/// nothing but the rod.
std::variant<RodLoop, std::string> rod_loop_of(const std::vector<DraftBody>& draft,
                                               const Connect& connect, const DrivenJoints& driven);

}  // namespace torquewright::hopper
