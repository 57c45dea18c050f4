// SPDX-License-Identifier: Apache-2.0
#include "io/text/force_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::io {

std::string force_text(double force_N, int digits) {
  constexpr double kKilo = 1000.0;
  const bool is_large = std::abs(force_N) >= kKilo;
  return is_large ? fmt::format("{:.{}g} kN", force_N / kKilo, digits)
                  : fmt::format("{:.{}g} N", force_N, digits);
}

}  // namespace torquewright::io
