// SPDX-License-Identifier: Apache-2.0
#include "optimization/fit/quantile.hpp"

#include <algorithm>
#include <cstddef>

namespace torquewright::optimization {
namespace {

/// What stands there in ascending order.
double value_at(std::vector<double>& values, std::size_t place) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double way_through(const std::vector<double>& values, double share) {
  return share * static_cast<double>(values.size() - 1);
}

}  // namespace

double nearest_quantile(std::vector<double> values, double share) {
  return value_at(values, static_cast<std::size_t>(way_through(values, share) + 0.5));
}

double lower_quantile(std::vector<double> values, double share) {
  return value_at(values, static_cast<std::size_t>(way_through(values, share)));
}

double median(std::vector<double> values) { return value_at(values, values.size() / 2); }

}  // namespace torquewright::optimization
