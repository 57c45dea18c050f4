// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/outputs/output.hpp"

// One line for each output; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_OUTPUT(output) output(frc) output(bam)

namespace torquewright::identification::outputs {

#define TORQUEWRIGHT_DECLARE(name) extern const Output name;
TORQUEWRIGHT_EVERY_OUTPUT(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::identification::outputs
