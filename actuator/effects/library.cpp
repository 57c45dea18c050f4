// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/library.hpp"

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator {

std::span<const EffectKind* const> effect_library() {
#define LIST(name) &effects::name,
  static constexpr const EffectKind* kEffects[] = {TORQUEWRIGHT_EVERY_EFFECT(LIST)};
#undef LIST
  return kEffects;
}

const EffectKind* find_effect(std::string_view name) {
  for (const EffectKind* kind : effect_library()) {
    if (kind->name == name) return kind;
  }
  return nullptr;
}

Effect neutral(const EffectKind& kind) {
  Effect effect;
  effect.kind = &kind;
  for (const Parameter& parameter : kind.parameters) effect.values.push_back(parameter.neutral);
  return effect;
}

}  // namespace torquewright::actuator
