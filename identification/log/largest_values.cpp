// SPDX-License-Identifier: Apache-2.0
#include "identification/log/largest_values.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace torquewright::identification {

LargestValues::LargestValues(std::size_t most_values, double least_share)
    : kept_(static_cast<std::size_t>((1.0 - least_share) * static_cast<double>(most_values)) + 2) {}

void LargestValues::add(double value) {
  ++count_;
  if (heap_.size() == kept_) {
    if (value <= heap_.front()) return;
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.back() = value;
  } else {
    heap_.push_back(value);
  }
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

double LargestValues::quantile(double share) const {
  const std::size_t last = count_ - 1;
  const std::size_t above =
      last - static_cast<std::size_t>(share * static_cast<double>(last) + 0.5);
  if (above >= heap_.size()) throw std::logic_error("a quantile below what was kept");
  std::vector<double> sorted = heap_;
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(above);
  std::nth_element(sorted.begin(), place, sorted.end(), std::greater<>());
  return *place;
}

}  // namespace torquewright::identification
