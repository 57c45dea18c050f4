// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/moved_stretch.hpp"

#include <cmath>
#include <numbers>

#include "identification/forward/histories.hpp"

namespace torquewright::identification {
namespace {

using actuator::Effect;
using actuator::Instant;

constexpr double kMostTurnsPerSample = 0.5;  ///< Of a wave: faster, it would fold.

template <typename Field>
void advance_field(std::vector<Instant>& at, Field Instant::*field, double delay_s, double step_s) {
  std::vector<double> values(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) values[i] = at[i].*field;
  values = advanced(values, delay_s, step_s);
  for (std::size_t i = 0; i < at.size(); ++i) at[i].*field = values[i];
}

void advance_motion(std::vector<Instant>& at, double delay_s, double step_s) {
  for (auto field : {&Instant::speed_rad_s, &Instant::acceleration_rad_s2,
                     &Instant::output_angle_rad, &Instant::motor_angle_rad, &Instant::direction}) {
    advance_field(at, field, delay_s, step_s);
  }
}

double turns_per_rad(const Effect& effect, const actuator::Harmonic& wave, double ratio) {
  const bool is_of_motor = effect.kind->acts == actuator::Acts::kMotorSideTorque;
  return wave.order * (is_of_motor ? std::abs(ratio) : 1.0) / (2.0 * std::numbers::pi);
}

}  // namespace

MovedStretch::MovedStretch(const Signals& signals, double late_s, double ratio, std::size_t most)
    : step_s_(signals.step_s),
      cutoff_Hz_(signals.cutoff_Hz),
      ratio_(ratio),
      at_(signals.at),
      rotor_rad_s2_(signals.motor_acceleration_rad_s2),
      drags_(most),
      ripples_(most),
      plains_(most),
      histories_(most),
      gains_(most) {
  if (cutoff_Hz_ > 0.0) filter_.emplace(cutoff_Hz_, 1.0 / signals.sample_step_s);
  for (std::size_t i = 0; i < signals.filtered_direction.size(); ++i) {
    at_[i].direction = signals.filtered_direction[i];
  }
  if (late_s != 0.0) {
    advance_motion(at_, late_s, step_s_);
    if (!rotor_rad_s2_.empty()) rotor_rad_s2_ = advanced(rotor_rad_s2_, late_s, step_s_);
  }
  const bool has_rotor = !rotor_rad_s2_.empty();
  for (const Instant& at : at_) {
    if (!has_rotor) rotor_rad_s2_.push_back(at.acceleration_rad_s2);
    forward_shares_.push_back(0.5 * (1.0 + at.direction));
  }
}

std::shared_ptr<const DirectedSeries> MovedStretch::drag(const Effect& effect) {
  return drags_.of(effect, [&] {
    DirectedSeries series{LawSeries(at_.size(), 0.0), LawSeries(at_.size(), 0.0)};
    at_every_sample(effect, [&](const Effect& seen, std::size_t i) {
      Instant at = at_[i];
      const double forward = forward_shares_[i];
      at.direction = 1.0;
      // Waves of friction oppose both directions alike.
      const bool is_wave = seen.kind->has_harmonics;
      if (is_wave || forward != 0.0) series.forward[i] = seen.kind->law(seen, at);
      at.direction = -1.0;
      if (is_wave) {
        series.backward[i] = -series.forward[i];
      } else if (forward != 1.0) {
        series.backward[i] = seen.kind->law(seen, at);
      }
    });
    return series;
  });
}

std::shared_ptr<const LawSeries> MovedStretch::ripple(const Effect& effect) {
  return ripples_.of(effect, [&] {
    LawSeries series(at_.size());
    at_every_sample(effect, [&](const Effect& seen, std::size_t i) {
      Instant at = at_[i];
      at.load_torque_Nm = 1.0;
      series[i] = seen.kind->law(seen, at);
    });
    return series;
  });
}

std::shared_ptr<const LawSeries> MovedStretch::plain(const Effect& effect) {
  return plains_.of(effect, [&] {
    LawSeries series(at_.size());
    at_every_sample(effect, [&](const Effect& seen, std::size_t i) {
      series[i] = seen.kind->law(seen, at_[i]);
    });
    return series;
  });
}

std::shared_ptr<const LawSeries> MovedStretch::friction_history(const Effect& effect) {
  return histories_.of(effect, [&] {
    return friction_history_Nm(effect, at_, speeds_of_parts_rad_s(), step_s_, cutoff_Hz_);
  });
}

template <typename Law>
void MovedStretch::at_every_sample(const Effect& effect, const Law& law) {
  Effect seen = effect;
  std::vector<std::shared_ptr<const LawSeries>> gains;
  for (const actuator::Harmonic& wave : effect.harmonics) {
    const double turns = turns_per_rad(effect, wave, ratio_);
    gains.push_back(gains_.of(turns, [&] { return gains_of_waves(turns); }));
  }
  for (std::size_t i = 0; i < at_.size(); ++i) {
    for (std::size_t h = 0; h < gains.size(); ++h) {
      seen.harmonics[h].amplitude = effect.harmonics[h].amplitude * (*gains[h])[i];
    }
    law(seen, i);
  }
}

LawSeries MovedStretch::gains_of_waves(double turns_per_rad) const {
  LawSeries gains;
  for (const Instant& at : at_) {
    const double frequency_Hz = turns_per_rad * std::abs(at.speed_rad_s);
    const bool would_fold = frequency_Hz * step_s_ > kMostTurnsPerSample;
    gains.push_back(would_fold ? 0.0 : filter_ ? filter_->gain(frequency_Hz) : 1.0);
  }
  return gains;
}

const LawSeries& MovedStretch::speeds_of_parts_rad_s() {
  if (!speeds_of_parts_rad_s_) {
    speeds_of_parts_rad_s_ = identification::speeds_of_parts_rad_s(at_, step_s_);
  }
  return *speeds_of_parts_rad_s_;
}

}  // namespace torquewright::identification
