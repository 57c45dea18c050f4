// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Adds findings on what the log is too poor to tell: constant channels, joints that never move
/// (kError), runs too short to be of use, too little to fit or to hold out (kError), many masked
/// samples. Requires that the hold-out is chosen.
void check_contents(Log& log, const Rig& rig);

}  // namespace torquewright::identification
