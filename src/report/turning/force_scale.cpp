// SPDX-License-Identifier: Apache-2.0
#include "src/report/turning/force_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/force_text.hpp"

namespace torquewright::report {
namespace {

constexpr double kHardBlow = 8.0;  // times the median force: it would have an eighth of the length

}  // namespace

double ForceScale::share(double force_N) const {
  return greatest_N > 0.0 ? std::pow(force_N / greatest_N, power()) : 0.0;
}

std::string ForceScale::words() const {
  if (!(greatest_N > 0.0)) return "force of the ground";
  return fmt::format(
      "force of the ground: the longest arrow is {}, {}", io::force_text(greatest_N, 3),
      is_root ? "a force of a quarter has half its length" : "the others in proportion");
}

ForceScale force_scale(std::vector<double> forces_N) {
  std::erase_if(forces_N, [](double force_N) { return !(force_N > 0.0); });
  if (forces_N.empty()) return {};
  const auto middle = forces_N.begin() + std::ssize(forces_N) / 2;
  std::nth_element(forces_N.begin(), middle, forces_N.end());
  const double greatest_N = *std::max_element(middle, forces_N.end());
  return {greatest_N, greatest_N > kHardBlow * *middle};
}

}  // namespace torquewright::report
