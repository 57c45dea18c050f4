// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <utility>

namespace torquewright::gearbox::test {

using Row = std::array<double, 4>;  ///< Three coefficients and the right-hand side.

/// Gauss elimination with pivoting of three equations.
inline std::array<double, 3> solve(std::array<Row, 3> rows) {
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < 3; ++row) {
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    }
    std::swap(rows[column], rows[pivot]);
    for (std::size_t row = 0; row < 3; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t entry = 0; entry < 4; ++entry)
        rows[row][entry] -= factor * rows[column][entry];
    }
  }
  return {rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
}

}  // namespace torquewright::gearbox::test
