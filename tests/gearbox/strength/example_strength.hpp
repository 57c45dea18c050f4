// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/strength/tooth_load.hpp"

namespace torquewright::gearbox::test {

inline GearMaterial case_hardened() {
  return {Treatment::kCaseHardened, 206e3, .3, 425, 1500, std::nullopt};
}

/// The example of the D110A: every size is assumed.
inline StrengthCase d110a_strength() {
  StrengthCase strength;
  strength.train = {"planetary", {21, 63, 147}, {0, 0, 0}, 3, .6, {10}};
  strength.material = case_hardened();
  strength.factors = {1, 1, 1.1, 1.2, 1.3, .7};
  strength.cycles = 1e5;
  strength.demanded_root_safety = 1.4;
  strength.demanded_flank_safety = 1.1;
  return strength;
}

/// The D151's published teeth.
inline StrengthCase d151_strength() {
  StrengthCase strength = d110a_strength();
  strength.train = {"3k", {44, 44, 32, 132, 120}, {0, 0, 0, 0, 0}, 4, .6, {10, 12}};
  return strength;
}

}  // namespace torquewright::gearbox::test
