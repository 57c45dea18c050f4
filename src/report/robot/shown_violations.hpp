// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hopper/check/series.hpp"
#include "src/report/robot/hopper_page.hpp"

namespace torquewright::report {

struct Interval {
  double from_s = 0.0;
  double until_s = 0.0;
};

/// A violation as the page shows it: when, and on which bodies.
struct ShownViolation {
  std::string name;  ///< Of the drive, joint or contact; may be empty.
  std::string rule;
  std::string sentence;
  std::vector<std::size_t> bodies;  ///< To be drawn in red.
  double worst_s = 0.0;
  std::vector<Interval> times;  ///< Ascending; gaps too short to be seen are closed.

  bool holds_at(double time_s) const;
};

/// Where that is so of samples, from the first to the last of each stretch; gaps too short to be
/// seen are closed.
std::vector<Interval> stretches(const std::vector<double>& times_s,
                                const std::function<bool(Eigen::Index)>& is_so);

/// All that have a time. A region's and a joint limit's last as long as samples lie beyond, a
/// load's as long as its window; of all others the worst instant is known.
std::vector<ShownViolation> shown_violations(const HopperPage& page, const hopper::Series& series);

/// 1 where the drive's torque lies outside its region, else 0. Requires the series of drives.
Eigen::VectorXd outside_region(const hopper::Series& series, const std::string& drive);

}  // namespace torquewright::report
