// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::actuator {

struct MotorRange;
struct PhaseModel;

/// motor_range without closed forms and without Newton's method for the ends: their oracle, and
/// what motor_range falls back on.
MotorRange motor_range_by_search(const PhaseModel& model, double speed_rad_s);

}  // namespace torquewright::actuator
