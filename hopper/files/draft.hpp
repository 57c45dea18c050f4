// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/files/element.hpp"
#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

/// A body as a file has it: perhaps welded to its parent, perhaps without mass.
struct DraftBody {
  dynamics::Body body;  ///< Parents come first.
  bool is_welded = false;
  const Element* source = nullptr;  ///< Of the inertia; null where the file states no such body.
  double rounding_kg_m2 = 0;        ///< By so much its moments may be off by how they are written.
};

/// A robot read from another format, and what was left behind, in sentences.
struct Imported {
  Robot robot;
  std::vector<std::string> notes;
};

/// Welded bodies become part of their parents.
std::vector<dynamics::Body> without_welds(const std::vector<DraftBody>& draft);

}  // namespace torquewright::hopper
