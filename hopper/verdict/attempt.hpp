// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/verdict/deed.hpp"
#include "hopper/verdict/flights.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Heights of the centre of mass over time.
struct HeightPath {
  std::vector<double> times_s;
  std::vector<double> heights_m;

  /// Returns the greatest height between two times less the path's first; 0 where the path has
  /// nothing there.
  double rise_m(const TimeInAir& between) const;
  /// Returns the first height less the least.
  double dip_m() const;
};

/// A run beside the motion that it was to make: what every deed is judged by. Refers to what it is
/// made of.
struct Attempt {
  /// `robot` is that of the run, `planned` the motion's flights. Requires a record with rows.
  Attempt(const Robot& robot, const Reference& reference, const std::vector<TimeInAir>& planned,
          const Record& record, const DeedTolerances& tolerances);

  /// Returns the row of the run at a time, or the last before it.
  const RecordRow& row_at(double time_s) const;

  const Robot& robot;
  const Reference& reference;
  const Record& record;
  DeedTolerances tolerances;
  std::vector<MatchedFlight> flights;
  HeightPath planned_path;
  HeightPath run_path;
};

/// Returns how far apart two places may be where the motion's is some way from where it began, in
/// m.
double allowed_distance_m(const DeedTolerances& tolerances, double way_m);

}  // namespace torquewright::hopper
