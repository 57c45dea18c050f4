// SPDX-License-Identifier: Apache-2.0
#include "io/text/shown_number.hpp"

#include <algorithm>
#include <cmath>

#include "io/text/number_text.hpp"

namespace torquewright::io {
namespace {

/// Of what a system of equations gives, as contact forces: two fewer than of a sum.
constexpr int kSolvedDigits = 10;

}  // namespace

double shown(double value, double scale, int digits) {
  const double size = std::max(std::abs(value), std::abs(scale));
  if (!std::isfinite(size) || size == 0.0) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(size)) + 1 - digits);
  return known(std::round(value / unit) * unit);
}

double without_noise(double value, double scale) {
  return shown(value, scale, kSolvedDigits) == 0.0 ? 0.0 : value;
}

}  // namespace torquewright::io
