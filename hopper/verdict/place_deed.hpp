// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/verdict/attempt.hpp"

namespace torquewright::hopper {

/// Judges where those points stand that touch in one of the motion's modes: in the motion at one
/// time, in the run at another. Planned and done are the way from where they were at the begin,
/// done along the planned one. Name and owner are the caller's to fill in.
Deed place_deed(const Attempt& attempt, const TouchingPoints& touches, double planned_s,
                double run_s);

}  // namespace torquewright::hopper
