// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

namespace torquewright::actuator {

/// The clock that stamped a log's rows. A motion does not last a day: times beyond one are those of
/// a clock that runs since some epoch (1.7e9 s since 1970 in any ROS bag), and are counted from the
/// first row instead, since six digits of them are all the same.
class Clock {
 public:
  /// Returns the time as the motion counts it.
  double since_origin_s(double time_s) {
    constexpr double kDay_s = 86400.0;
    if (!origin_s_) origin_s_ = std::abs(time_s) > kDay_s ? time_s : 0.0;
    return time_s - *origin_s_;
  }

  /// Shorter steps belong to times in other units, or damaged ones. A choice of ours.
  static constexpr double kShortestStep_s = 1e-9;
  /// Later times belong to a clock in other units: no epoch is as long ago.
  static constexpr double kLatest_s = 1e11;

  /// Origin of the motion's times; 0: times are as they stand.
  double origin_s() const { return origin_s_.value_or(0.0); }

  /// Returns a sentence that times were shifted; empty where they were not.
  std::string sentence() const {
    if (origin_s() == 0.0) return "";
    return fmt::format("times are counted from the first row, {:.17g} s of the file's clock",
                       origin_s());
  }

 private:
  std::optional<double> origin_s_;
};

}  // namespace torquewright::actuator
