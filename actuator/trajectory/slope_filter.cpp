// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/slope_filter.hpp"

#include <algorithm>
#include <utility>

namespace torquewright::actuator {

SlopeFilter::SlopeFilter(std::vector<Pair> pairs, Sink sink)
    : pairs_(std::move(pairs)), sink_(std::move(sink)) {}

void SlopeFilter::push(const Row& row) {
  if (held_ == 3) std::rotate(rows_.begin(), rows_.begin() + 1, rows_.end());
  held_ = std::min<std::size_t>(held_ + 1, 3);
  rows_[held_ - 1] = row;
  if (held_ < 3) return;
  if (!std::exchange(is_first_emitted_, true)) emit(0);
  emit(1);
}

void SlopeFilter::finish() {
  if (held_ < 3) {
    for (std::size_t i = 0; i < held_; ++i) emit(i);
  } else {
    emit(2);
  }
}

void SlopeFilter::emit(std::size_t index) {
  Row row = rows_[index];
  for (const Pair& pair : pairs_) {
    const auto time_s = [this](std::size_t i) { return rows_[i].time_s; };
    const auto quotient = [&](std::size_t i) {
      return (rows_[i + 1].values[pair.from] - rows_[i].values[pair.from]) /
             (time_s(i + 1) - time_s(i));
    };
    double slope = held_ > 1 ? quotient(0) : 0.0;
    if (held_ == 3) {
      // Newton's form of the parabola: its slope is [t0,t1] + [t0,t1,t2] (2 t - t0 - t1).
      const double curvature = (quotient(1) - quotient(0)) / (time_s(2) - time_s(0));
      slope += curvature * ((row.time_s - time_s(0)) + (row.time_s - time_s(1)));
    }
    row.values[pair.to] = slope;
  }
  sink_(row);
}

}  // namespace torquewright::actuator
