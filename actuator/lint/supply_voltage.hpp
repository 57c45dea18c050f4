// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/lint/check.hpp"

namespace torquewright::actuator::lint {

/// Explanation of a no-load speed or a stall current, which both go with the voltage: it was stated
/// at another one than the rest of the sheet, the drive's bus voltage or a preferred voltage of IEC
/// 60038. One explanation at the most; none where the voltage that would be needed is no such one.
std::vector<Explanation> other_voltage(const Actuator& document, const RoundedInterval& stated,
                                       const RoundedInterval& expected);

}  // namespace torquewright::actuator::lint
