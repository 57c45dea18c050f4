// SPDX-License-Identifier: Apache-2.0
#include "identification/log/stale_rows.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

constexpr double kOfThePace = 3.0;      ///< Most that the pace changes by within the rows.
constexpr double kLeastSteps = 3.0;     ///< Of the position's resolution: slower may be one of it.
constexpr double kRounding = 1e-9;      ///< Of a step: differences that are none;
constexpr double kRoundedDigits = 2.5;  ///< so are four roundings to the last digit.

}  // namespace

void Resolution::add(double step, double digit) {
  const double size = std::max(std::abs(step), std::abs(last_step_));
  const double rounding = std::max(kRoundedDigits * digit, kRounding * size);
  note(std::abs(step), rounding);
  note(std::abs(step - last_step_), rounding);
  last_step_ = step;
}

void Resolution::note(double difference, double rounding) {
  if (difference > rounding && (least_ == 0.0 || difference < least_)) least_ = difference;
}

bool are_stale(const Travel& travel, std::size_t repeats, double next_s, double next_position) {
  const std::size_t rows = travel.position.size();
  if (repeats == 0 || rows < repeats + 2) return false;
  const std::size_t held = rows - 1 - repeats;
  const double before = travel.position[held] - travel.position[held - 1];
  const double across = next_position - travel.position[held];
  const double least = kLeastSteps * travel.resolution;
  if (std::abs(before) < least || std::abs(across) < least || before * across <= 0.0) return false;
  const double pace_before = before / (travel.time_s[held] - travel.time_s[held - 1]);
  const double pace_across = across / (next_s - travel.time_s[held]);
  const double ratio = pace_across / pace_before;
  return ratio >= 1.0 / kOfThePace && ratio <= kOfThePace;
}

}  // namespace torquewright::identification
