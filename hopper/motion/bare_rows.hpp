// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/motion/channel.hpp"

namespace torquewright::hopper {

/// A motion's file without a header and perhaps without times, as tools that retarget motions write
/// it. Empty `order`: the file has a header.
struct BareRows {
  /// What stands in the columns, from the left: `time`; `base` (its place), `quaternion_xyzw`,
  /// `quaternion_wxyz`, `pitch`; `base_velocity`, `base_angular`; `joints`, `joint_velocities`
  /// (all, in the robot's order); a joint's name or a canonical header; `skip`.
  std::vector<std::string> order;
  double rows_per_s = 0.0;  ///< 0: the file has times.
};

/// The canonical headers of all columns; a skipped one has a name of its own. Throws io::SpecError,
/// with the nearest word, for a word that there is not or that the robot's base does not have, and
/// where times stand in the order and rows per second are stated too, or neither.
std::vector<std::string> headers_of(const BareRows& rows, const std::vector<Channel>& channels);

}  // namespace torquewright::hopper
