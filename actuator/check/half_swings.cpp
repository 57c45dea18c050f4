// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/half_swings.hpp"

#include <cmath>
#include <utility>

namespace torquewright::actuator {
namespace {

/// Of a swing's height: motion nearer to its turning point counts as rest. A choice of ours.
constexpr double kNear = 0.25;

}  // namespace

double HalfSwings::unseen_rad() const { return kNear * height_rad_; }

bool HalfSwings::is_near(const Travel& one, const Travel& other) const {
  return std::abs(change_rad(one, other)) <= unseen_rad();
}

void HalfSwings::begin_at(const Travel& turn, const Travel& leaves, const Travel& now) {
  start_ = turn;
  leaves_ = leaves;
  farthest_ = stays_ = arrives_ = now;
}

void HalfSwings::go_on(const Travel& now) {
  if (direction_ * change_rad(farthest_, now) > 0.0) farthest_ = now;
  if (is_near(farthest_, now)) stays_ = now;
  if (is_near(start_, now)) leaves_ = arrives_ = now;
  if (direction_ * change_rad(arrives_, now) > unseen_rad()) arrives_ = now;
}

/// Nothing has turned yet: the lowest row counts as the start, the highest as the farthest, until
/// one of them is left by the height.
void HalfSwings::look_for_start(const Travel& now) {
  if (change_rad(start_, now) < 0.0) start_ = now;
  if (is_near(start_, now)) leaves_ = now;
  if (change_rad(farthest_, now) > 0.0) farthest_ = now;
  if (is_near(farthest_, now)) stays_ = now;
  if (change_rad(start_, now) > height_rad_) {
    direction_ = 1.0;
    begin_at(start_, leaves_, now);
  } else if (change_rad(farthest_, now) < -height_rad_) {
    direction_ = -1.0;
    begin_at(farthest_, stays_, now);
  }
}

std::optional<HalfSwing> HalfSwings::add(const Travel& now) {
  if (!has_begun_) begin_at(now, now, now);
  has_begun_ = true;
  if (direction_ == 0.0) {
    look_for_start(now);
    return std::nullopt;
  }
  if (direction_ * change_rad(farthest_, now) >= -height_rad_) {
    go_on(now);
    return std::nullopt;
  }
  const HalfSwing ended{leaves_, arrives_};
  direction_ = -direction_;
  begin_at(farthest_, stays_, now);
  return ended;
}

std::optional<HalfSwing> HalfSwings::rest() {
  if (std::exchange(direction_, 0.0) == 0.0) return std::nullopt;
  has_begun_ = false;
  return HalfSwing{leaves_, arrives_};
}

}  // namespace torquewright::actuator
