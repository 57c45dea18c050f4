// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/printed_digits.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "identification/reading/isolated.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kMostCells = 10000;

struct Written {
  int decimals = 0;  ///< Behind the point, less the exponent.
  int digits = 0;    ///< From the first that is not 0 on.
  bool is_zero() const { return digits == 0; }
  int leading() const { return digits - decimals - 1; }
};

Written written(std::string_view cell) {
  Written found;
  bool is_behind_point = false;
  std::size_t at = 0;
  for (; at < cell.size() && cell[at] != 'e' && cell[at] != 'E'; ++at) {
    if (cell[at] == '.') is_behind_point = true;
    if (cell[at] < '0' || cell[at] > '9') continue;
    if (is_behind_point) ++found.decimals;
    if (cell[at] != '0' || found.digits > 0) ++found.digits;
  }
  if (at == cell.size()) return found;
  int exponent = 0;
  const std::size_t first = at + (at + 1 < cell.size() && cell[at + 1] == '+' ? 2 : 1);
  std::from_chars(cell.data() + first, cell.data() + cell.size(), exponent);
  found.decimals -= exponent;
  return found;
}

}  // namespace

void PrintedDigits::add(std::string_view cell) {
  if (cells_ == kMostCells) return;
  ++cells_;
  const Written found = written(cell);
  decimals_ = std::max(decimals_, found.decimals);
  digits_ = std::max(digits_, found.digits);
  if (found.is_zero()) {
    ++zeros_;
  } else {
    ++leading_[found.leading()];
  }
}

int PrintedDigits::greatest_usual() const {
  const auto most = static_cast<std::size_t>(kMostIsolated * static_cast<double>(cells_));
  std::size_t above = 0;
  for (auto at = leading_.rbegin(); at != leading_.rend(); ++at) {
    above += at->second;
    if (above > most) return at->first;
  }
  return leading_.empty() ? 0 : leading_.begin()->first;
}

double PrintedDigits::last_digit() const {
  if (cells_ == 0) return 0.0;
  double sum = static_cast<double>(zeros_) * std::pow(10.0, -2.0 * decimals_);
  const int usual = greatest_usual();
  for (const auto& [leading, count] : leading_) {
    const int last = std::max(-decimals_, std::min(leading, usual) + 1 - digits_);
    sum += static_cast<double>(count) * std::pow(10.0, 2.0 * last);
  }
  return std::sqrt(sum / static_cast<double>(cells_));
}

}  // namespace torquewright::identification
