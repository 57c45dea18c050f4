// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::learning {

/// How a vector looks in a mirror: entry i of the mirrored one is sign[i] x[from[i]].
struct MirroredVector {
  std::vector<int> from;
  std::vector<double> sign;  ///< 1 or -1 each.
};

/// The task's mirror plane: an observation and the action that belongs to it, mirrored, belong
/// together too. Mirroring twice is no change.
struct Mirror {
  MirroredVector actor;  ///< Of what the actor sees.
  MirroredVector action;
};

}  // namespace torquewright::learning
