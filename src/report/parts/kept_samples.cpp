// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/kept_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace torquewright::report {
namespace {

using Eigen::Index;
using Samples = std::set<Index>;

void keep_extremes(const Eigen::VectorXd& values, Index from, Index until, Samples& kept) {
  Index least = -1;
  Index greatest = -1;
  for (Index i = from; i < until; ++i) {
    if (!std::isfinite(values[i])) continue;
    if (least < 0 || values[i] < values[least]) least = i;
    if (greatest < 0 || values[i] > values[greatest]) greatest = i;
  }
  if (least >= 0) kept.insert({least, greatest});
}

std::vector<Index> all_of(Index count) {
  std::vector<Index> samples(static_cast<std::size_t>(count));
  std::iota(samples.begin(), samples.end(), Index{0});
  return samples;
}

}  // namespace

std::vector<Index> curve_samples(const Eigen::VectorXd& values, Index buckets) {
  const Index count = values.size();
  if (count <= 2 * buckets) return all_of(count);
  Samples kept{0, count - 1};
  for (Index bucket = 0; bucket < buckets; ++bucket) {
    const Index from = bucket * count / buckets;
    const Index until = (bucket + 1) * count / buckets;
    keep_extremes(values, from, until, kept);
    for (Index i = from; i < until; ++i) {
      if (std::isfinite(values[i])) continue;
      kept.insert(i);
      break;
    }
  }
  return {kept.begin(), kept.end()};
}

std::vector<Index> cursor_samples(const std::vector<double>& times_s,
                                  const std::vector<const Eigen::VectorXd*>& columns,
                                  const std::vector<Index>& wanted, Index most) {
  const auto count = static_cast<Index>(times_s.size());
  if (count <= most) return all_of(count);
  Samples kept(wanted.begin(), wanted.end());
  const double step_s = (times_s.back() - times_s.front()) / static_cast<double>(most - 1);
  for (Index i = 0; i < most; ++i) {
    const double time_s = times_s.front() + static_cast<double>(i) * step_s;
    const auto next = std::lower_bound(times_s.begin(), times_s.end(), time_s);
    kept.insert(std::min<Index>(next - times_s.begin(), count - 1));
  }
  for (const Eigen::VectorXd* column : columns) keep_extremes(*column, 0, count, kept);
  return {kept.begin(), kept.end()};
}

}  // namespace torquewright::report
