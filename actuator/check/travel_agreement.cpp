// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/travel_agreement.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/check/time_gap.hpp"

namespace torquewright::actuator {
namespace {

/// Fewer windows say nothing: three rows of a jump may all be at rest.
constexpr std::size_t kFewestWindows = 8;
/// Of the travel, left over in every kind of window. A filter that lags by a tenth of a radian of
/// the motion's phase leaves a tenth; a constant in the place of half a sine at its mean four
/// tenths.
constexpr double kContradiction = 0.3;
/// Of the greatest travel in any kind of window: with less, whole swings cancel, or too few windows
/// move enough to be seen.
constexpr double kUncancelled = 0.5;
/// A slower left-over, of the no-load speed, moves no verdict.
constexpr double kLeastSpeedShare = 0.01;
/// Play, rounding and flexing gears may be all of what a window moves by: about one degree.
constexpr double kLeastTravel_rad = 0.02;

}  // namespace

/// What a joint did meanwhile is not known, and both may be right.
bool TravelAgreement::is_gap(double step_s) const {
  return rows_ > 1 && step_s > kGap * (last_s_ - first_s_) / static_cast<double>(rows_ - 1);
}

void TravelAgreement::add(double time_s, double position_rad, double velocity_rad_s) {
  const double step_s = time_s - last_s_;
  if (rows_ == 0) {
    first_s_ = time_s;
    now_.time_s = least_.time_s = greatest_.time_s = time_s;
  } else if (!is_gap(step_s)) {
    const Window window{step_s, position_rad - last_position_rad_,
                        0.5 * step_s * (velocity_rad_s + last_velocity_rad_s_),
                        0.5 * step_s * std::abs(velocity_rad_s - last_velocity_rad_s_)};
    now_ = {time_s, now_.position_rad + window.position_rad,
            now_.velocity_rad + window.velocity_rad};
    if (now_.left_over_rad() < least_.left_over_rad()) least_ = now_;
    if (now_.left_over_rad() > greatest_.left_over_rad()) greatest_ = now_;
    add_window(window);
  }
  ++rows_;
  last_s_ = time_s;
  last_position_rad_ = position_rad;
  last_velocity_rad_s_ = velocity_rad_s;
}

/// Counted at its own scale, and joined with the one before it at the next.
void TravelAgreement::add_window(Window window) {
  for (std::size_t i = 0;; ++i) {
    if (i == scales_.size()) scales_.emplace_back();
    Scale& scale = scales_[i];
    ++scale.windows;
    scale.duration_s += window.duration_s;
    const double travel_rad =
        std::max(std::abs(window.position_rad), std::abs(window.velocity_rad));
    if (travel_rad > kLeastTravel_rad) {
      const double left_over_rad =
          std::max(0.0, std::abs(window.position_rad - window.velocity_rad) - window.tolerance_rad);
      scale.travel_rad += travel_rad;
      scale.left_over_rad += left_over_rad;
      scale.left_over_rad2_s += left_over_rad * left_over_rad / window.duration_s;
    }
    if (!scale.half) {
      scale.half = window;
      return;
    }
    window = {scale.half->duration_s + window.duration_s,
              scale.half->position_rad + window.position_rad,
              scale.half->velocity_rad + window.velocity_rad,
              scale.half->tolerance_rad + window.tolerance_rad};
    scale.half.reset();
  }
}

bool TravelAgreement::contradicts(const Scale& scale, double no_load_speed_rad_s) const {
  const double speed_rad_s = std::sqrt(scale.left_over_rad2_s / scale.duration_s);
  return scale.left_over_rad > kContradiction * scale.travel_rad &&
         speed_rad_s > kLeastSpeedShare * no_load_speed_rad_s;
}

std::optional<TravelContradiction> TravelAgreement::contradiction(
    double no_load_speed_rad_s) const {
  double most_rad = 0.0;
  for (const Scale& scale : scales_) {
    if (scale.windows >= kFewestWindows) most_rad = std::max(most_rad, scale.travel_rad);
  }
  if (most_rad == 0.0) return std::nullopt;
  for (const Scale& scale : scales_) {
    if (scale.windows < kFewestWindows || scale.travel_rad < kUncancelled * most_rad) continue;
    if (!contradicts(scale, no_load_speed_rad_s)) return std::nullopt;
  }
  const bool is_rising = least_.time_s < greatest_.time_s;
  const Mark& from = is_rising ? least_ : greatest_;
  const Mark& until = is_rising ? greatest_ : least_;
  return TravelContradiction{from.time_s, until.time_s, until.position_rad - from.position_rad,
                             until.velocity_rad - from.velocity_rad};
}

}  // namespace torquewright::actuator
