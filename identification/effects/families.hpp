// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/effects/dictionary_builder.hpp"

namespace torquewright::identification {

/// One family of effects each: its columns, and the variants that a search may choose. A new family
/// is a file beside this one, and its line here and in kFamilies.
void add_plain_friction(DictionaryBuilder& builder);
void add_stribeck(DictionaryBuilder& builder);
void add_load_friction(DictionaryBuilder& builder);
void add_presliding(DictionaryBuilder& builder);
void add_torque_constant(DictionaryBuilder& builder);
void add_temperature(DictionaryBuilder& builder);
void add_waves(DictionaryBuilder& builder);
void add_inertia(DictionaryBuilder& builder);
void add_lag_and_delay(DictionaryBuilder& builder);
void add_voltage(DictionaryBuilder& builder);
void add_offsets(DictionaryBuilder& builder);
void add_backlash(DictionaryBuilder& builder);

/// In this order; Coulomb friction's column comes before those that take its place.
constexpr void (*kFamilies[])(DictionaryBuilder&) = {
    add_plain_friction,  add_stribeck,    add_load_friction, add_presliding,
    add_torque_constant, add_temperature, add_waves,         add_inertia,
    add_lag_and_delay,   add_voltage,     add_offsets,       add_backlash,
};

}  // namespace torquewright::identification
