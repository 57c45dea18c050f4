// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/limiter_words.hpp"

namespace torquewright::actuator {

std::string_view name_of(Limiter limiter, bool has_battery) {
  const bool is_supply = limiter == Limiter::kBatteryPower && !has_battery;
  return is_supply ? "supply_current" : name_of(limiter);
}

}  // namespace torquewright::actuator
