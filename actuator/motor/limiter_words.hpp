// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// A limiter in words for people: where there is no battery, the power that a supply gives is
/// limited by its current. Documents say battery_power of both.
std::string_view name_of(Limiter limiter, bool has_battery);

}  // namespace torquewright::actuator
