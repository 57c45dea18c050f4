// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string_view>

namespace torquewright::identification {

/// Finds to which digit a column's numbers are written. A format has a number of decimals, or of
/// significant digits, and cells may lack their zeros at the end: so the column's longest cells
/// tell the digit of all.
class PrintedDigits {
 public:
  /// Adds a cell that holds a number. Only the first 10 000 count.
  void add(std::string_view cell);

  /// Root mean square of a change by one in the last digit; 0 without cells. The greatest cells, as
  /// many as may be isolated faults, count as the next ones do.
  double last_digit() const;

 private:
  /// Greatest power of ten of the leading digits, without those that single faults may have.
  int greatest_usual() const;

  std::size_t cells_ = 0, zeros_ = 0;
  int decimals_ = -400;                 ///< Most decimals of a cell.
  int digits_ = 0;                      ///< Most significant digits of a cell.
  std::map<int, std::size_t> leading_;  ///< Number of cells by the power of ten of the first digit.
};

}  // namespace torquewright::identification
