// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/steels.hpp"

#include <algorithm>

namespace torquewright::gearbox {

const std::vector<Steel>& steels() {
  static const std::vector<Steel> list{
      {"case_hardened",
       {.treatment = Treatment::kCaseHardened,
        .young_MPa = 206000.0,
        .poisson = 0.3,
        .bending_endurance_MPa = 430.0,
        .contact_endurance_MPa = 1500.0,
        .yield_MPa = {}},
       "The numbers are GEARpie's (cfernandesFEUP/GEARpie, CLASSES/MATERIAL_LIBRARY.py, STEEL), "
       "which names no grade; that they are of case-hardened teeth is our reading."}};
  return list;
}

const Steel* find_steel(std::string_view name) {
  const auto found = std::find_if(steels().begin(), steels().end(),
                                  [&](const Steel& steel) { return steel.name == name; });
  return found == steels().end() ? nullptr : &*found;
}

}  // namespace torquewright::gearbox
