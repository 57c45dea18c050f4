// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::actuator {

/// A step of more than this many others' length is said: integrals and slopes run straight across.
constexpr double kGap = 20.0;

}  // namespace torquewright::actuator
