// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::hopper {

/// What a reader of foreign files may be told.
struct ImportFileOptions {
  std::string
      body;  ///< Of the world's bodies this one is the robot; empty: the only one that moves.
  bool mends_inertias = false;  ///< Those that miss the triangle inequality by their own rounding.
};

}  // namespace torquewright::hopper
