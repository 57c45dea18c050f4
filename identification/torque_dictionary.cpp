// SPDX-License-Identifier: Apache-2.0
#include "identification/balance.hpp"
#include "identification/dictionary.hpp"
#include "identification/effects/families.hpp"

namespace torquewright::identification {

std::string_view name_of(EffectFamily family) {
  switch (family) {
    case EffectFamily::kActuator:
      return "actuator";
    case EffectFamily::kRig:
      return "rig";
    case EffectFamily::kLog:
      return "log";
  }
  return "";
}

Dictionary torque_dictionary(const Bench& bench, const Extent& extent, const Orders& orders) {
  DictionaryBuilder builder(bench, extent, orders);
  for (const auto& add_family : kFamilies) add_family(builder);
  return builder.take();
}

std::vector<double> torque_residual(const Bench& bench, const Signals& signals) {
  const Balance balance(bench);
  std::vector<double> residual(signals.size());
  for (std::size_t i = 0; i < signals.size(); ++i) residual[i] = balance.residual_Nm(signals, i);
  return residual;
}

}  // namespace torquewright::identification
