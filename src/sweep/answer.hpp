// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace torquewright::sweep {

/// What came of a point.
struct Answer {
  bool is_lost = false;  ///< The process that did it ended before it had an answer.
  std::string row;       ///< JSON on one line; empty where lost.
  std::string why;       ///< Of the loss.
};

struct PointAnswer {
  std::size_t point = 0;
  Answer answer;
};

}  // namespace torquewright::sweep
