// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/gain_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace torquewright::hopper {

GainSchedule::GainSchedule(std::vector<GainStretch> by_mode, Eigen::MatrixXd after_end,
                           double ends_s)
    : by_mode_(std::move(by_mode)), after_end_(std::move(after_end)), ends_s_(ends_s) {}

const Eigen::MatrixXd& GainSchedule::at(std::size_t mode, double time_s) const {
  const GainStretch& stretch = by_mode_[std::min(mode, by_mode_.size() - 1)];
  if (time_s >= ends_s_ || stretch.gains.empty()) return after_end_;
  const double last = static_cast<double>(stretch.gains.size() - 1);
  const double place = std::clamp((time_s - stretch.from_s) / stretch.step_s, 0.0, last);
  return stretch.gains[static_cast<std::size_t>(place)];
}

}  // namespace torquewright::hopper
