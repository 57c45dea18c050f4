// SPDX-License-Identifier: Apache-2.0
#include "io/text/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace torquewright::io {
namespace {

constexpr int kKnownDigits = 12;
constexpr int kKeptDigits = 15;  // DBL_DIG
// So many zeros or nines in a row are no accident: of one number in 10^4.
constexpr std::size_t kNoiseDigits = 6;

}  // namespace

double known(double value, double scale) {
  const double size = std::max(std::abs(value), std::abs(scale));
  if (!std::isfinite(size) || size == 0.0) return value == 0.0 ? 0.0 : value;
  const int last_place = static_cast<int>(std::floor(std::log10(size))) + 1 - kKnownDigits;
  if (last_place < 0) {
    return std::strtod(fmt::format("{:.{}f}", value, -last_place).c_str(), nullptr) + 0.0;
  }
  const double unit = std::pow(10.0, last_place);
  return std::round(value / unit) * unit + 0.0;  // not -0
}

std::string known_text(double value, double scale) {
  return fmt::format("{}", known(value, scale));
}

std::string precise_text(double value) {
  const double kept = std::strtod(fmt::format("{:.{}g}", value, kKeptDigits).c_str(), nullptr);
  std::string exact = fmt::format("{}", value), decimal = fmt::format("{}", kept);
  return decimal.size() + kNoiseDigits <= exact.size() ? decimal : exact;
}

}  // namespace torquewright::io
