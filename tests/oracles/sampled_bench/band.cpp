// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/band.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace torquewright::oracles::sampled {
namespace {

void low_pass(std::vector<double>& values, double period_s) {
  if (values.empty()) return;
  const double k = std::tan(std::numbers::pi * kBand_hz * period_s);  // bilinear transform
  const double scale = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  const double b = k * k * scale;
  const double a1 = 2.0 * (k * k - 1.0) * scale;
  const double a2 = (1.0 - std::numbers::sqrt2 * k + k * k) * scale;
  double x1 = values.front(), x2 = x1, y1 = x1, y2 = x1;
  for (double& value : values) {
    const double y = b * (value + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1;
    x1 = value;
    y2 = y1;
    y1 = y;
    value = y;
  }
}

}  // namespace

std::vector<double> in_band(const std::vector<double>& values, double period_s) {
  std::vector<double> passed = values;
  low_pass(passed, period_s);
  std::reverse(passed.begin(), passed.end());
  low_pass(passed, period_s);
  std::reverse(passed.begin(), passed.end());
  return passed;
}

double band_rms(const Courses& courses, double period_s) {
  const auto edge = static_cast<std::size_t>(0.25 / period_s);
  double sum = 0.0;
  std::size_t count = 0;
  for (const std::vector<double>& course : courses) {
    const std::vector<double> passed = in_band(course, period_s);
    for (std::size_t k = edge; k + edge < passed.size(); ++k, ++count) {
      sum += passed[k] * passed[k];
    }
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

std::vector<double> rate_of(const std::vector<double>& values, double period_s) {
  std::vector<double> rates(values.size(), 0.0);
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    rates[k] = (values[k + 1] - values[k - 1]) / (2.0 * period_s);
  }
  return rates;
}

}  // namespace torquewright::oracles::sampled
