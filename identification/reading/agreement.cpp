// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace torquewright::identification {
namespace {

/// Half the window: long against noise of an encoder's counts, short against a swing.
constexpr double kHalfWindow_s = 0.02;
constexpr std::size_t kLeastHalfWindow = 2;

std::size_t half_window(const Run& run) {
  const std::size_t samples = run.time_s.size();
  if (samples < 2) return kLeastHalfWindow;
  const double step_s = (run.time_s.back() - run.time_s.front()) / static_cast<double>(samples - 1);
  const double wanted = std::min(kHalfWindow_s / step_s, static_cast<double>(samples));
  return std::max(kLeastHalfWindow, static_cast<std::size_t>(wanted));
}

/// Sums up to before each sample.
std::vector<double> running_sum(const std::vector<double>& values) {
  std::vector<double> sums(values.size() + 1, 0.0);
  std::partial_sum(values.begin(), values.end(), sums.begin() + 1);
  return sums;
}

/// Calls with the ends of each window without a masked sample: first and last index.
template <typename Call>
void for_each_window(const Run& run, const Call& call) {
  const std::size_t half = half_window(run);
  const std::size_t width = 2 * half;
  std::size_t clean = 0;  // samples since the last masked one
  for (std::size_t last = 0; last < run.masked.size(); ++last) {
    clean = run.masked[last] != 0 ? 0 : clean + 1;
    if (clean > width) call(last - width, last);
  }
}

double mean_between(const std::vector<double>& sums, std::size_t first, std::size_t last) {
  return (sums[last + 1] - sums[first]) / static_cast<double>(last + 1 - first);
}

void subtract_mean(std::vector<double>& values) {
  if (values.empty()) return;
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& value : values) value -= mean;
}

}  // namespace

void AgreementSums::add(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> one = first;
  std::vector<double> other = second;
  subtract_mean(one);
  subtract_mean(other);
  first_first_ += std::inner_product(one.begin(), one.end(), one.begin(), 0.0);
  second_second_ += std::inner_product(other.begin(), other.end(), other.begin(), 0.0);
  first_second_ += std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
  samples_ += one.size();
}

Agreement AgreementSums::result() const {
  const double product = std::sqrt(first_first_) * std::sqrt(second_second_);
  if (!(product > 0.0) || !std::isfinite(product)) return {samples_, 0.0, 0.0};
  return {samples_, first_second_ / product, std::sqrt(first_first_) / std::sqrt(second_second_)};
}

Slopes slopes(const Run& run, const std::vector<double>& position,
              const std::vector<double>& other) {
  Slopes result;
  const std::vector<double> sums = running_sum(other);
  for_each_window(run, [&](std::size_t first, std::size_t last) {
    result.slope.push_back((position[last] - position[first]) /
                           (run.time_s[last] - run.time_s[first]));
    result.mean.push_back(mean_between(sums, first, last));
  });
  return result;
}

Means means(const Run& run, const std::vector<double>& first, const std::vector<double>& second) {
  Means result;
  const std::vector<double> first_sums = running_sum(first);
  const std::vector<double> second_sums = running_sum(second);
  for_each_window(run, [&](std::size_t begin, std::size_t last) {
    result.first.push_back(mean_between(first_sums, begin, last));
    result.second.push_back(mean_between(second_sums, begin, last));
  });
  return result;
}

}  // namespace torquewright::identification
