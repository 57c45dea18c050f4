// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/drive_check/report.hpp"

namespace torquewright::actuator {

/// Thins a motion of any length to at most kMostPoints points for a picture: every n-th sample, n
/// doubled whenever there are too many. Samples outside the region are thinned apart, so that few
/// of them among many others stay visible.
class Trace {
 public:
  void add(const TracePoint& point);

  /// Returns all points, ascending in time.
  std::vector<TracePoint> points() const;
  static constexpr std::size_t kMostPoints = 8000;

 private:
  class Thinned {
   public:
    void add(const TracePoint& point);
    const std::vector<TracePoint>& points() const { return points_; }

   private:
    std::vector<TracePoint> points_;
    std::size_t stride_ = 1;
    std::size_t count_ = 0;
  };
  Thinned inside_;
  Thinned outside_;
};

}  // namespace torquewright::actuator
