// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <vector>

namespace torquewright::hopper {

/// Numbers of `count` variables in a row.
inline std::vector<int> numbers_from(int first, Eigen::Index count) {
  std::vector<int> out(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = first + static_cast<int>(i);
  return out;
}

inline std::vector<int> in_order(std::initializer_list<std::vector<int>> parts) {
  std::vector<int> out;
  for (const std::vector<int>& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

}  // namespace torquewright::hopper
