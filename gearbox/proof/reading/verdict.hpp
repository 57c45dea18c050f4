// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace torquewright::gearbox::proof {

/// What the checker went through.
struct Counts {
  std::int64_t nodes = 0;
  std::int64_t cuts = 0;
  std::int64_t splits = 0;
  std::int64_t empty_leaves = 0;
  std::int64_t enumerated_leaves = 0;
  std::int64_t relaxation_leaves = 0;
  std::int64_t open_leaves = 0;
  std::int64_t enumerated_points = 0;
};

/// What the checker found.
struct Verdict {
  bool accepted = false;            ///< No faults: every claim of the result is proved.
  std::vector<std::string> faults;  ///< `JSON pointer: sentence`; the first hundred.
  Counts counts;
  bool undecided = false;  ///< Status "limit": the bound is proved, the optimum is not.
  bool ended = false;      ///< The checker was told to stop: neither accepted nor refuted.
};

}  // namespace torquewright::gearbox::proof
