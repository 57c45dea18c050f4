// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/left_out_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/torque_at.hpp"

namespace torquewright::actuator {
namespace {

bool turns_on_angle(const Effect& effect) { return effect.kind->acts == Acts::kOutputTorque; }

/// Whether a failure rests on torques beyond the region alone.
bool fails_by_torque_alone(CheckedInterpretation interpretation) {
  interpretation.clipped_samples = 0;
  return !fails(interpretation);
}

}  // namespace

LeftOutSizes::LeftOutSizes(const Actuator& actuator, Part part)
    : effects_(effects_left_out(actuator, part)), law_Nm_(effects_.size(), 0.0) {
  extremes_.motor_inertia_kg_m2 = reflected_inertia_kg_m2(actuator);
}

void LeftOutSizes::add(const Sample& sample) {
  if (effects_.empty()) return;
  some_angles_are_unknown_ = some_angles_are_unknown_ || !sample.position_rad;
  extremes_.torque_Nm = std::max(extremes_.torque_Nm, std::abs(sample.torque_Nm));
  if (last_ && sample.time_s > last_->time_s) {
    const double rate_Nm_s =
        (sample.torque_Nm - last_->torque_Nm) / (sample.time_s - last_->time_s);
    extremes_.torque_rate_Nm_s = std::max(extremes_.torque_rate_Nm_s, std::abs(rate_Nm_s));
  }
  last_ = sample;
  Instant at;
  at.speed_rad_s = sample.speed_rad_s;
  at.direction = sample.speed_rad_s < 0.0 ? -1.0 : 1.0;
  at.acceleration_rad_s2 = sample.acceleration_rad_s2;
  at.load_torque_Nm = sample.torque_Nm;
  at.output_angle_rad = sample.position_rad.value_or(0.0);
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    law_Nm_[i] = std::max(law_Nm_[i], std::abs(effects_[i]->kind->law(*effects_[i], at)));
  }
}

std::vector<LeftOutEffect> LeftOutSizes::finish() const {
  std::vector<LeftOutEffect> sizes;
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    const EffectKind& kind = *effects_[i]->kind;
    LeftOutEffect& size = sizes.emplace_back();
    size.effect = kind.name;
    if (kind.misjudged_Nm != nullptr) {
      size.misjudged_Nm = kind.misjudged_Nm(*effects_[i], extremes_);
    } else if (!turns_on_angle(*effects_[i]) || !some_angles_are_unknown_) {
      size.misjudged_Nm = law_Nm_[i];
    }
  }
  return sizes;
}

bool outweighs(const LeftOutEffect& effect, const CheckedInterpretation& interpretation) {
  if (fails(interpretation) && !fails_by_torque_alone(interpretation)) return false;
  return !effect.misjudged_Nm || *effect.misjudged_Nm > std::abs(interpretation.margin_Nm);
}

bool some_outweigh(const std::vector<LeftOutEffect>& effects,
                   const CheckedInterpretation& interpretation) {
  return std::any_of(effects.begin(), effects.end(), [&](const LeftOutEffect& effect) {
    return outweighs(effect, interpretation);
  });
}

}  // namespace torquewright::actuator
