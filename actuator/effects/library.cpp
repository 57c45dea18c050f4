// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/library.hpp"

#include <stdexcept>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator {
namespace {

template <typename Claim>
const EffectKind& first_that(const Claim& claim) {
  for (const EffectKind* kind : effect_library()) {
    if (claim(*kind)) return *kind;
  }
  throw std::logic_error("the library of effects has none that is asked for");
}

}  // namespace

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

std::vector<const EffectKind*> effects_standing_for(StandsFor what) {
  std::vector<const EffectKind*> all;
  for (const EffectKind* kind : effect_library()) {
    if (kind->stands_for == what) all.push_back(kind);
  }
  return all;
}

bool stands_for(std::string_view name, StandsFor what) {
  const EffectKind* kind = find_effect(name);
  return kind != nullptr && kind->stands_for == what;
}

bool is_wave_of_friction(std::string_view name) {
  const EffectKind* kind = find_effect(name);
  return kind != nullptr && kind->has_harmonics && kind->acts == Acts::kDrag;
}

AtRest at_rest_of(std::string_view name) {
  const EffectKind* kind = find_effect(name);
  return kind == nullptr ? AtRest::kNothing : kind->at_rest;
}

const EffectKind& first_friction(AtRest at_rest) {
  return first_that([&](const EffectKind& kind) { return kind.at_rest == at_rest; });
}

const EffectKind& first_wave(Acts acts) {
  return first_that(
      [&](const EffectKind& kind) { return kind.has_harmonics && kind.acts == acts; });
}

}  // namespace torquewright::actuator
