// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/gain_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace torquewright::hopper {

namespace {

/// Which of a stretch's numbers holds at a time.
std::size_t place_in(const GainStretch& stretch, double time_s) {
  const double last = static_cast<double>(stretch.gains.size() - 1);
  return static_cast<std::size_t>(
      std::clamp((time_s - stretch.from_s) / stretch.step_s, 0.0, last));
}

}  // namespace

GainSchedule::GainSchedule(std::vector<GainStretch> by_mode, Gains after_end,
                           ErrorModel model_after, double ends_s)
    : by_mode_(std::move(by_mode)),
      after_end_(std::move(after_end)),
      model_after_(std::move(model_after)),
      ends_s_(ends_s) {}

const Gains& GainSchedule::at(std::size_t mode, double time_s) const {
  const GainStretch& stretch = by_mode_[std::min(mode, by_mode_.size() - 1)];
  if (time_s >= ends_s_ || stretch.gains.empty()) return after_end_;
  return stretch.gains[place_in(stretch, time_s)];
}

const ErrorModel* GainSchedule::model_at(std::size_t mode, double time_s) const {
  if (model_after_.by_error.size() == 0) return nullptr;
  const GainStretch& stretch = by_mode_[std::min(mode, by_mode_.size() - 1)];
  if (time_s >= ends_s_ || stretch.models.empty()) return &model_after_;
  return &stretch.models[place_in(stretch, time_s)];
}

std::optional<WeighedPeriod> GainSchedule::weighed_before(std::size_t mode, double time_s) const {
  const GainStretch& stretch = by_mode_[std::min(mode, by_mode_.size() - 1)];
  const double middle_s = time_s - 0.5 * stretch.step_s;
  if (stretch.weighing.empty() || middle_s > ends_s_) return std::nullopt;
  const std::size_t place = place_in(stretch, middle_s);
  return WeighedPeriod{stretch.models[place], stretch.weighing[place]};
}

}  // namespace torquewright::hopper
