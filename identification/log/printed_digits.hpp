// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string_view>

namespace torquewright::identification {

/// To which digit a column's numbers are written. A format has a number of decimals, or of
/// significant digits, and cells may lack their zeros at the end: so the column's longest cells
/// tell the digit of all.
class PrintedDigits {
 public:
  /// A cell that holds a number. The first 10 000 count.
  void add(std::string_view cell);

  /// Root mean square of what one more in the last digit adds; 0 without cells. The greatest
  /// cells, as many as may be isolated faults, count as the next ones do.
  double last_digit() const;

 private:
  /// Of the leading digits, without those that single faults may be.
  int greatest_usual() const;

  std::size_t cells_ = 0, zeros_ = 0;
  int decimals_ = -400;                 ///< The most.
  int digits_ = 0;                      ///< Significant, the most.
  std::map<int, std::size_t> leading_;  ///< Power of ten of the first digit: how many cells.
};

}  // namespace torquewright::identification
