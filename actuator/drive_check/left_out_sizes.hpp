// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/drive_check/report.hpp"
#include "actuator/region/left_out.hpp"

namespace torquewright::actuator {

/// Estimates how much the effects that a part leaves out matter in a motion: the greatest torque of
/// those whose law follows from a sample, and for those with a history the estimate of their record
/// (EffectKind::misjudged_Nm) by the motion's extremes (docs/derivations/check.md eqs. (14) to
/// (16)).
class LeftOutSizes {
 public:
  struct Sample {
    double time_s = 0.0;
    std::optional<double> position_rad;  ///< Angle of the output.
    double speed_rad_s = 0.0;
    double torque_Nm = 0.0;
    double acceleration_rad_s2 = 0.0;
  };

  /// Keeps references into the actuator.
  LeftOutSizes(const Actuator& actuator, Part part);

  void add(const Sample& sample);
  std::vector<LeftOutEffect> finish() const;

 private:
  std::vector<const Effect*> effects_;
  std::vector<double> law_Nm_;  ///< Greatest torque so far, by effect.
  bool some_angles_are_unknown_ = false;
  MotionExtremes extremes_;
  std::optional<Sample> last_;
};

/// Whether an effect is larger than the torque margin on which the verdict rests: what is missing
/// of a torque that fails, what is left of one that passes. A verdict that fails by heat or by
/// continuous limits rests on none.
bool some_outweigh(const std::vector<LeftOutEffect>& effects,
                   const CheckedInterpretation& interpretation);

/// Whether one effect is larger than that margin.
bool outweighs(const LeftOutEffect& effect, const CheckedInterpretation& interpretation);

}  // namespace torquewright::actuator
