// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/series.hpp"
#include "hopper/record/record.hpp"

namespace torquewright::hopper {

/// A run by time, a row a control instant: a motion as `hopper check` reads it, beside it the
/// drives (wanted, acting and cut-off torque, speed, bus voltage) and what the ground gave since
/// the row before (force, its mean over that time).
Series run_series(const Robot& robot, const Record& record);

}  // namespace torquewright::hopper
