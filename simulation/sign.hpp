// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::simulation {

/// Sign of a number: -1, 0 or 1.
inline double sign_of(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

}  // namespace torquewright::simulation
