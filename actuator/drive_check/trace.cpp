// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/trace.hpp"

#include <algorithm>
#include <iterator>

namespace torquewright::actuator {

void Trace::Thinned::add(const TracePoint& point) {
  if (count_++ % stride_ != 0) return;
  if (points_.size() == kMostPoints / 2) {
    for (std::size_t i = 0; i < kMostPoints / 4; ++i) points_[i] = points_[2 * i];
    points_.resize(kMostPoints / 4);
    stride_ *= 2;
    if ((count_ - 1) % stride_ != 0) return;
  }
  points_.push_back(point);
}

void Trace::add(const TracePoint& point) { (point.is_outside ? outside_ : inside_).add(point); }

std::vector<TracePoint> Trace::points() const {
  std::vector<TracePoint> all;
  std::merge(
      inside_.points().begin(), inside_.points().end(), outside_.points().begin(),
      outside_.points().end(), std::back_inserter(all),
      [](const TracePoint& one, const TracePoint& other) { return one.time_s < other.time_s; });
  return all;
}

}  // namespace torquewright::actuator
