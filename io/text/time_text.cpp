// SPDX-License-Identifier: Apache-2.0
#include "io/text/time_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::io {
namespace {

constexpr int kAllDigits = 17;  ///< Of a double.

}  // namespace

std::string time_text(double time_s, int digits) {
  const double size_s = std::abs(time_s);
  const int before_point = size_s < 10.0 ? 1 : 1 + static_cast<int>(std::log10(size_s));
  const int at_least = before_point + digits - 2;
  return fmt::format("{:.{}g}", time_s, std::clamp(at_least, digits, kAllDigits));
}

}  // namespace torquewright::io
