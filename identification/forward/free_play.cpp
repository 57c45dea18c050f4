// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/free_play.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

/// The body on its way.
class FreeBody {
 public:
  FreeBody(const FreeSide& side, double inertia_kg_m2, double gap_rad)
      : side_(side), inertia_kg_m2_(inertia_kg_m2), half_rad_(0.5 * gap_rad) {
    place_rad_ = std::copysign(half_rad_, side.push_Nm(0, 0.0, 0.0));
  }

  /// Half an interval in `count` steps; returns the mean of what the speed changes of the push.
  double advance(std::size_t sample, double from_share, double span_s, int count) {
    if (stays(sample, from_share) && stays(sample, from_share + 0.5)) return 0.0;
    double changed_Nm = 0.0;
    for (int k = 0; k < count; ++k) {
      changed_Nm += step(sample, from_share + 0.5 * (k + 0.5) / count, span_s / count);
    }
    return changed_Nm / count;
  }

  double place_rad() const { return place_rad_; }
  double speed_rad_s() const { return speed_rad_s_; }

 private:
  /// It rests on a flank, and is pushed there.
  bool stays(std::size_t sample, double share) const {
    return speed_rad_s_ == 0.0 && std::abs(place_rad_) >= half_rad_ &&
           side_.push_Nm(sample, share, 0.0) * place_rad_ >= 0.0;
  }

  double step(std::size_t sample, double share, double step_s) {
    if (stays(sample, share)) return 0.0;
    const double push_Nm = side_.push_Nm(sample, share, speed_rad_s_);
    speed_rad_s_ += step_s * push_Nm / inertia_kg_m2_;
    place_rad_ += step_s * speed_rad_s_;
    if (std::abs(place_rad_) >= half_rad_) {
      place_rad_ = std::copysign(half_rad_, place_rad_);
      speed_rad_s_ = 0.0;
    }
    return push_Nm - side_.push_Nm(sample, share, 0.0);
  }

  const FreeSide& side_;
  double inertia_kg_m2_;
  double half_rad_;
  double place_rad_;
  double speed_rad_s_ = 0.0;
};

}  // namespace

GapMotion move_in_gap(const FreeSide& side, double inertia_kg_m2, double gap_rad, double step_s) {
  const std::size_t samples = side.samples();
  const std::vector<double> nothing(samples, 0.0);
  GapMotion motion{nothing, nothing, nothing};
  if (samples == 0 || !(gap_rad > 0.0) || !(step_s > 0.0)) return motion;
  FreeBody body(side, inertia_kg_m2, gap_rad);
  const auto count = static_cast<int>(std::max(1.0, std::ceil(0.5 * step_s / kFreePlayStep_s)));
  double before_rad_s = 0.0, before_Nm = 0.0;  // Of the half interval before the sample.
  for (std::size_t i = 0; i < samples; ++i) {
    motion.place_rad[i] = body.place_rad();
    const double after_Nm = body.advance(i, 0.0, 0.5 * step_s, count);
    motion.acceleration_rad_s2[i] = (body.speed_rad_s() - before_rad_s) / step_s;
    motion.push_change_Nm[i] = 0.5 * (before_Nm + after_Nm);
    before_rad_s = body.speed_rad_s();
    before_Nm = body.advance(i, 0.5, 0.5 * step_s, count);
  }
  return motion;
}

}  // namespace torquewright::identification
