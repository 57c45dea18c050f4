// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/line_loss.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

constexpr double kLastRoot = 0.9;  // of x: from there on a parabola

/// 2 / (1 + sqrt(1 - x)) and its slopes.
Taylor of_root(double x) {
  const double s = std::sqrt(1.0 - x);
  const double t = 1.0 / (1.0 + s);
  return {.value = 2.0 * t, .x = t * t / s, .xx = t * t / (2.0 * s * s * s) + t * t * t / (s * s)};
}

}  // namespace

Taylor line_factor(double x) {
  Taylor f = of_root(std::min(x, kLastRoot));
  const double further = std::max(0.0, x - kLastRoot);
  f.value += further * (f.x + 0.5 * further * f.xx);
  f.x += further * f.xx;
  return f;
}

}  // namespace torquewright::hopper
