// SPDX-License-Identifier: Apache-2.0
#include "identification/compatibility.hpp"

#include <algorithm>

namespace torquewright::identification {
namespace {

bool is_same(const Variant& a, const Variant& b) {
  const bool is_same_wave = a.order == b.order && a.proportional == b.proportional;
  return a.effect == b.effect && (b.order == 0.0 || is_same_wave);
}

/// One holds the other, or both hold a third.
bool overlap(const Variant& a, const Variant& b) {
  if (contains(a, b.effect) || contains(b, a.effect)) return true;
  return std::any_of(a.replaces.begin(), a.replaces.end(),
                     [&](const std::string& name) { return contains(b, name); });
}

bool is_pair(const Variant& one, const Variant& other, const char* a, const char* b) {
  return (one.effect == a && other.effect == b) || (one.effect == b && other.effect == a);
}

}  // namespace

bool contains(const Variant& whole, const std::string& part) {
  return std::find(whole.replaces.begin(), whole.replaces.end(), part) != whole.replaces.end();
}

bool is_compatible(const Dictionary& dictionary, const Members& members, std::size_t added,
                   bool target_is_motor_side, bool is_free_load) {
  const Variant& variant = dictionary.variants[added];
  for (const std::size_t member : members) {
    const Variant& other = dictionary.variants[member];
    if (is_same(other, variant) || overlap(variant, other)) return false;
    // Torque constant and inertia together span the current of a rig without a sensor.
    if (target_is_motor_side && is_free_load &&
        is_pair(variant, other, "torque_constant_error", "reflected_inertia")) {
      return false;
    }
    if (is_pair(variant, other, "asymmetric_friction", "torque_offset")) return false;
    // What is left of one beside the other is neither's own.
    if (is_pair(variant, other, "torque_lag", "channel_delay")) return false;
  }
  return !variant.scales_friction || dictionary.nominal_drag_warmed != Dictionary::kNone;
}

}  // namespace torquewright::identification
